#pragma once

#include "core/export/jobs/jobs.h"
#include "ui/export/queue_file.h"
#include "ui/concurrency/async_request.h"

#include <deque>
#include <functional>
#include <memory>

namespace fumage::ui {

/// Looks whether exports that are to be started write files of others that wait, one export after the other, on a
/// thread of its own: the disk may be slow.
class StartCheck : public QObject {
    Q_OBJECT

public:
    /// @param others gives those that wait or run, without those that are looked at
    explicit StartCheck(std::function<ExportJobs()> others, QObject* parent = nullptr);

    void start(quint64 id, std::shared_ptr<const ExportJob> job);
    /// Nothing more comes of one.
    void giveUp(quint64 id);

signals:
    /// @param apart an error where another writes one of its files
    void answered(quint64 id, const fumage::Status& apart);

private:
    struct Wanted {
        quint64 id = 0;
        std::shared_ptr<const ExportJob> job;
    };
    /// Looks at the first of those that wait; none: rests.
    void goOn();
    void end(const ExportJobs& asked, const Status& apart);

    const std::function<ExportJobs()> m_others;
    std::deque<Wanted> m_wanted; ///< the first is being looked at
    AsyncRequest m_job; ///< last: its thread ends first
};

} // namespace fumage::ui
