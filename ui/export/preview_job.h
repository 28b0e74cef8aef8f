#pragma once

#include "core/export/sheets/sheet_preview.h"
#include "ui/concurrency/async_request.h"

#include <QString>

#include <memory>

namespace fumage::ui {

/// Renders what a flipbook will hold, on a thread of its own; what is asked for last counts.
class PreviewJob : public QObject {
    Q_OBJECT

public:
    /// @param shelf see ExportTask
    explicit PreviewJob(std::shared_ptr<AirCache> shelf, QObject* parent = nullptr);

    void start(const Scene& scene, const ExportPlan& plan);
    /// Nothing more comes of what was asked for.
    void stop() { m_job.forget(); }

signals:
    void progressed(int percent);
    void ready(const std::shared_ptr<const fumage::SheetPreview>& preview);
    void failed(const QString& message);

private:
    const std::shared_ptr<AirCache> m_shelf;
    AsyncRequest m_job;
};

} // namespace fumage::ui
