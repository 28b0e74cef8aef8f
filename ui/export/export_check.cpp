#include "ui/export/export_check.h"

#include "ui/document/text.h"

#include "core/base/parallel.h"
#include "core/export/plan_check.h"

#include <algorithm>

#include <QElapsedTimer>
#include <QStringList>

namespace fumage::ui {

namespace {

constexpr qint64 kNewsEachMs = 100; ///< more often nobody reads it, and files may be many and small
constexpr qsizetype kMaxNamed = 3;

QString describe(const CheckedFile& file)
{
    const QString name = toQString(file.file);
    switch (file.state) {
    case FileState::Missing: return ExportCheck::tr("%1 is missing").arg(name);
    case FileState::Different: return ExportCheck::tr("%1 is different").arg(name);
    case FileState::Broken: return ExportCheck::tr("%1 is broken").arg(name);
    case FileState::Contradicted: return ExportCheck::tr("the manifest says two things of %1").arg(name);
    case FileState::Extra: return ExportCheck::tr("%1 is not in the manifest").arg(name);
    case FileState::NotAFile: return ExportCheck::tr("%1 is not a file").arg(name);
    case FileState::Unreadable: return ExportCheck::tr("%1 cannot be read").arg(name);
    case FileState::Same: break;
    }
    return {};
}

CheckMark markOf(const std::vector<CheckedFile>& files)
{
    QStringList named;
    qsizetype wrong = 0;
    for (const CheckedFile& file : files) {
        if (file.state != FileState::Same && wrong++ < kMaxNamed) {
            named << describe(file);
        }
    }
    const QString all = QString::number(files.size());
    if (wrong == 0) {
        return {.state = CheckState::Same,
            .told = files.size() == 1 ? ExportCheck::tr("Verified: the file is as it was written")
                                      : ExportCheck::tr("Verified: %1 files are as they were written").arg(all)};
    }
    if (wrong > kMaxNamed) {
        named << ExportCheck::tr("%1 more").arg(wrong - kMaxNamed);
    }
    const QString which = named.join(QStringLiteral(", "));
    // Names of files may hold what looks like a place for another: all are put in at once.
    return {.state = CheckState::Failed,
        .told = wrong == 1 ? ExportCheck::tr("1 of %1 files is not as it was written: %2").arg(all, which)
                           : ExportCheck::tr("%1 of %2 files are not as they were written: %3")
                                 .arg(QString::number(wrong), all, which)};
}

} // namespace

ExportCheck::ExportCheck(QObject* parent)
    : QObject(parent)
{
}

std::deque<ExportCheck::Wanted>::iterator ExportCheck::find(quint64 id)
{
    return std::ranges::find(m_wanted, id, &Wanted::id);
}

void ExportCheck::start(quint64 id, std::shared_ptr<const ExportJob> job)
{
    if (find(id) != m_wanted.end()) {
        return;
    }
    m_wanted.push_back({id, std::move(job)});
    emit marked(id, {.state = CheckState::Running, .told = tr("Verifying…")});
    if (m_wanted.size() == 1) {
        goOn();
    }
}

void ExportCheck::giveUp(quint64 id)
{
    const auto found = find(id);
    if (found == m_wanted.end()) {
        return;
    }
    const bool isLookedAt = found == m_wanted.begin();
    m_wanted.erase(found);
    if (isLookedAt) {
        goOn();
    }
    emit marked(id, {});
}

void ExportCheck::goOn()
{
    if (m_wanted.empty()) {
        m_job.forget();
        return;
    }
    m_job.ask(
        [this, wanted = m_wanted.front()](const AsyncRequest::Report& report, const std::stop_token& stop) {
            QElapsedTimer sinceNews;
            const auto progress = [&](ProgressPhase, int done, int total) {
                if (sinceNews.isValid() && sinceNews.elapsed() < kNewsEachMs) {
                    return;
                }
                sinceNews.start();
                report([this, id = wanted.id, done, total] {
                    emit marked(id, {CheckState::Running, done, total, tr("Verifying: %1 of %2").arg(done).arg(total)});
                });
            };
            Result<std::vector<CheckedFile>> checked = std::vector<CheckedFile>();
            runBehindOthers([&] {
                checked = checkExport(wanted.job->preset.scene, wanted.job->plan, {progress, stop});
            });
            report([this,
                       mark = checked ? markOf(checked.value())
                                      : CheckMark{.state = CheckState::Failed,
                                          .told = fumage::ui::translated(checked.error())}] { end(mark); });
        },
        [this](const Error& why) { end({.state = CheckState::Failed, .told = fumage::ui::translated(why)}); });
}

void ExportCheck::end(const CheckMark& mark)
{
    const quint64 id = m_wanted.front().id;
    m_wanted.pop_front();
    goOn();
    emit marked(id, mark);
}

} // namespace fumage::ui
