#include "ui/export/queue_file.h"

#include "ui/document/text.h"

#include <QFile>

#include <algorithm>
#include <iterator>

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
                  this, [this, jobs, status = keepAt(m_file.path, jobs)] { report(status, jobs); },
                  Qt::QueuedConnection);
          },
          [this](const ExportJobs& jobs, const Error& why) {
              QMetaObject::invokeMethod(
                  this, [this, jobs, why] { report(why, jobs); }, Qt::QueuedConnection);
          }))
{
}

QueueFile::~QueueFile()
{
    m_writer.reset(); // it may have dropped what it was asked for last
    if (keepAt(m_file.path, m_latest)) { // else nobody is left to be told
        removeLeft();
    }
}

void QueueFile::keep(ExportJobs jobs)
{
    m_latest = std::move(jobs);
    m_writer->post(m_latest);
}

void QueueFile::takeOver(const ExportJobs& jobs, std::vector<OwnFile> left)
{
    std::move(left.begin(), left.end(), std::back_inserter(m_left));
    m_latest = jobs;
    report(keepAt(m_file.path, jobs), jobs);
}

void QueueFile::report(const Status& status, const ExportJobs& written)
{
    if (status && written == m_latest) {
        removeLeft();
    } else if (!status && !m_hasFailed) {
        emit failed(translated(status.error()));
    }
    m_hasFailed = !status;
}

void QueueFile::removeLeft()
{
    for (const OwnFile& file : m_left) {
        QFile::remove(file.path);
    }
    m_left.clear();
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
        ExportJobs jobs;
        for (ExportJob& job : reading.value().jobs) {
            jobs.push_back(std::make_shared<const ExportJob>(std::move(job)));
        }
        found.lists.push_back({std::move(jobs), std::move(file)});
    }
    return found;
}

} // namespace fumage::ui
