#include "ui/export/queue_file.h"

#include "ui/document/text.h"

#include <QFile>

namespace fumage::ui {

namespace {

Status keepAt(const QString& path, const ExportJobs& jobs)
{
    if (!jobs.empty()) {
        return writeList(path, jobs, FileAccess::Private);
    }
    QFile::remove(path);
    return Done{};
}

} // namespace

Status writeList(const QString& path, const ExportJobs& jobs, FileAccess access)
{
    std::vector<ExportJob> list;
    for (const std::shared_ptr<const ExportJob>& job : jobs) {
        list.push_back(*job);
    }
    return writeJobsFile(toPath(path), list, access);
}

QueueFile::QueueFile(const QDir& folder, QObject* parent)
    : QObject(parent)
    , m_file(makeOwnFile(folder))
    , m_writer(std::make_unique<LatestOnlyWorker<ExportJobs>>(
          [this](const ExportJobs& jobs, const std::stop_token&) {
              QMetaObject::invokeMethod(
                  this, [this, status = keepAt(m_file.path, jobs)] { report(status); }, Qt::QueuedConnection);
          },
          [this](const ExportJobs&, const Error& why) {
              QMetaObject::invokeMethod(
                  this, [this, why] { report(why); }, Qt::QueuedConnection);
          }))
{
}

QueueFile::~QueueFile()
{
    m_writer.reset(); // it may have dropped what it was asked for last
    static_cast<void>(keepAt(m_file.path, m_latest)); // nobody is left to be told
}

void QueueFile::keep(ExportJobs jobs)
{
    m_latest = std::move(jobs);
    m_writer->post(m_latest);
}

void QueueFile::keepNow(const ExportJobs& jobs)
{
    m_latest = jobs;
    report(keepAt(m_file.path, jobs));
}

void QueueFile::report(const Status& status)
{
    if (!status && !m_hasFailed) {
        emit failed(translated(status.error()));
    }
    m_hasFailed = !status;
}

QueueFile::Leftovers QueueFile::find(const QDir& folder)
{
    Leftovers found;
    for (OwnFile& file : takeOrphans(folder)) {
        Result<JobsReading> reading = readJobsFile(toPath(file.path));
        if (!reading) {
            found.unreadable += file.path;
            continue;
        }
        for (ExportJob& job : reading.value().jobs) {
            found.jobs.push_back(std::make_shared<const ExportJob>(std::move(job)));
        }
        found.files.push_back(std::move(file));
    }
    return found;
}

} // namespace fumage::ui
