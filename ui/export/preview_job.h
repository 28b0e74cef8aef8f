#pragma once

#include "core/export/sheet_preview.h"
#include "ui/work/latest_job.h"

#include <QObject>
#include <QString>

#include <memory>

namespace fumage::ui {

/// Renders what a flipbook will hold, on a thread of its own; what is asked for last counts.
class PreviewJob : public QObject {
    Q_OBJECT

public:
    explicit PreviewJob(QObject* parent = nullptr);

    void start(const Effect& effect, const ExportPlan& plan);
    /// Nothing more comes of what was asked for.
    void stop();

signals:
    void progressed(int percent);
    void ready(const std::shared_ptr<const fumage::SheetPreview>& preview);
    void failed(const QString& message);

private:
    struct Request {
        quint64 number = 0;
        std::optional<std::pair<Effect, ExportPlan>> flipbook; ///< nothing: rest
    };
    void make(const Request& request, const std::stop_token& stop);

    quint64 m_number = 0; ///< of what was asked for last
    LatestJob<Request> m_job;
};

} // namespace fumage::ui
