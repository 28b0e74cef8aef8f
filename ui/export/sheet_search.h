#pragma once

#include "core/export/sheets/sheet_optimizer.h"
#include "ui/concurrency/async_request.h"

#include <QString>

namespace fumage::ui {

/// Finds the sheet that plays best within a budget of memory, on a thread of its own and behind all else that the
/// program computes.
class SheetSearch : public QObject {
    Q_OBJECT

public:
    explicit SheetSearch(QObject* parent = nullptr);

    /// @param plan for a flipbook @param budget bytes on the graphics card, as BC7
    void start(const Scene& scene, const ExportPlan& plan, std::int64_t budget);
    /// Nothing more comes of it.
    void stop() { m_job.forget(); }

signals:
    /// @param share 0 to 1
    void progressed(double share);
    void found(const fumage::SheetCandidate& best);
    void failed(const QString& message);

private:
    AsyncRequest m_job;
};

} // namespace fumage::ui
