#pragma once

#include "ui/document/own_file.h"
#include "ui/concurrency/latest_only_worker.h"

#include "core/export/jobs/job_file.h"

#include <QObject>
#include <QStringList>

#include <memory>
#include <vector>

namespace fumage::ui {

using ExportJobs = std::vector<std::shared_ptr<const ExportJob>>;

/// writeJobsFile() of jobs that are shared.
[[nodiscard]] Status writeList(const QString& path, const ExportJobs& jobs, FileAccess access);

/// Keeps the exports that are not done on disk, on a thread of its own: what is there when a program starts, and
/// belongs to no running one, is what a crash has left. For the user's eyes alone.
class QueueFile : public QObject {
    Q_OBJECT

public:
    /// @param folder made if it is not there
    explicit QueueFile(const QDir& folder, QObject* parent = nullptr);
    ~QueueFile() override;

    /// Soon these are on the disk, and no others; none: there is no file.
    void keep(ExportJobs jobs);
    /// Returns when they are, and the files are gone in which some of them were left; while they cannot be written
    /// those files stay, and belong to this program.
    void takeOver(const ExportJobs& jobs, std::vector<OwnFile> left);

    /// The list of a program that is gone.
    struct LeftList {
        ExportJobs jobs;
        OwnFile file; ///< that they were read from: takeOver() takes it away
    };
    /// What programs that are gone have left.
    struct Leftovers {
        std::vector<LeftList> lists; ///< the newest first
        QStringList unreadable; ///< files that are no lists; they stay
    };
    [[nodiscard]] static Leftovers find(const QDir& folder);

signals:
    /// The list cannot be written; once, until it can be again.
    void failed(const QString& message);

private:
    /// @param written what the disk was to hold
    void report(const Status& status, const ExportJobs& written);
    void removeLeft();

    const OwnFile m_file;
    std::vector<OwnFile> m_left; ///< by programs that are gone, until what they hold is in the file of this one
    bool m_hasFailed = false;
    ExportJobs m_latest; ///< what was to be kept last
    std::unique_ptr<LatestOnlyWorker<ExportJobs>> m_writer;
};

} // namespace fumage::ui
