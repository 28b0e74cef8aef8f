#include "ui/shell/export_desk.h"

#include "ui/export/export_dialog.h"
#include "ui/shell/action_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <QScreen>

namespace fumage::ui {

namespace {

/// Puts a dialog right of a window, as far as the screen goes: what is framed in the middle stays in sight.
void placeBeside(const QWidget& window, QWidget& dialog)
{
    const QRect screen = window.screen()->availableGeometry();
    const int most = screen.right() + 1 - dialog.frameGeometry().width();
    dialog.move(std::max(screen.left(), std::min(window.frameGeometry().right() + 1, most)), window.frameGeometry().top());
}

} // namespace

ExportDesk::ExportDesk(Document& document, Player& player, Locks& locks, const ActionSet& actions, const AskForFile& askForFile, const AskForChoice& askForChoice, QWidget* window)
    : m_document(document)
    , m_player(player)
    , m_locks(locks)
    , m_frame(actions.get("view.frame"))
    , m_askForFile(askForFile)
    , m_askForChoice(askForChoice)
    , m_window(window)
    , m_job(std::make_unique<ExportJob>())
{
    actions.on("file.export", this, [this] { openDialog(); });
    actions.on("file.exportAgain", this, &ExportDesk::exportAgain);
    connectNews();
}

ExportDesk::~ExportDesk() = default;

ExportDialog& ExportDesk::openDialog()
{
    if (m_dialog == nullptr) {
        m_dialog = std::make_unique<ExportDialog>(m_document, m_player, m_locks, *m_job, m_askForFile, m_askForChoice, m_window);
        connect(m_dialog.get(), &ExportDialog::shownChanged, this, [this] { m_againOnClash.reset(); });
        connect(m_dialog.get(), &ExportDialog::shownChanged, &m_frame, &QAction::setChecked);
    }
    const bool wasOpen = m_dialog->isVisible();
    m_dialog->show();
    if (!wasOpen) {
        placeBeside(*m_window, *m_dialog);
    }
    m_dialog->raise();
    return *m_dialog;
}

void ExportDesk::exportAgain()
{
    if (!m_job->lastPlan()) {
        openDialog();
        return;
    }
    if (m_job->isRunning()) {
        return;
    }
    ExportPlan plan = *m_job->lastPlan();
    if (const QStringList there = filesThere(plan); !there.isEmpty()) {
        const OnClash answer = m_againOnClash ? *m_againOnClash : askOnClash(m_window, m_askForChoice, there);
        if (answer == OnClash::Cancel) {
            return;
        }
        m_againOnClash = answer;
        if (answer == OnClash::NumberOn) {
            plan = numberedOn(plan);
        }
    }
    m_job->start(m_document.effect(), plan);
}

ExportDesk::Leaving ExportDesk::askBeforeLeaving() const
{
    if (!m_job->isRunning()) {
        return Leaving::Stop;
    }
    const int answer = m_askForChoice(m_window,
        {.name = QStringLiteral("exportRunsBox"),
            .title = tr("Export"),
            .text = tr("An export is being written."),
            .answers = {tr("Finish in the background and close"), tr("Stop the export and close"), tr("Cancel")}});
    constexpr std::array kAnswers{Leaving::Finish, Leaving::Stop, Leaving::Stay};
    return kAnswers[static_cast<std::size_t>(answer)];
}

std::unique_ptr<ExportJob> ExportDesk::takeJob()
{
    m_dialog.reset(); // it shows that job
    m_job->disconnect(this);
    std::unique_ptr<ExportJob> job = std::exchange(m_job, std::make_unique<ExportJob>());
    connectNews();
    return job;
}

void ExportDesk::connectNews()
{
    constexpr int kShownMs = 8000;
    connect(m_job.get(), &ExportJob::progressed, this, [this](int done, int total, double secondsLeft) {
        emit news(tr("Exporting: %1 of %2 files, %3 s left").arg(done).arg(total).arg(std::ceil(secondsLeft)), 0);
    });
    connect(m_job.get(), &ExportJob::preparing, this, [this](const QString& what) { emit news(tr("Exporting. %1").arg(what), 0); });
    connect(m_job.get(), &ExportJob::finished, this, [this](const QString& file) { emit news(tr("Exported %1").arg(file), kShownMs); });
    connect(m_job.get(), &ExportJob::cancelled, this, [this] { emit news(tr("Export cancelled"), kShownMs); });
    connect(m_job.get(), &ExportJob::failed, this, [this](const QString& message) { emit news(tr("Export failed: %1").arg(message), 0); });
}

} // namespace fumage::ui
