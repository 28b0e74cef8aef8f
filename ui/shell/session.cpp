#include "ui/shell/session.h"

#include "ui/export/export_job.h"
#include "ui/shell/key_guard.h"
#include "ui/shell/main_window.h"

#include "core/base/parallel.h"

#include <QApplication>
#include <QEventLoopLocker>

namespace fumage::ui {

namespace {

/// What is to be known of copies of unsaved work that are not opened; empty: nothing.
QString remarkOn(const Recovery::Leftovers& left)
{
    QStringList lines;
    if (!left.unreadable.isEmpty()) {
        lines += Session::tr("A copy of unsaved work cannot be read. It stays where it is: %1").arg(left.unreadable.join(QStringLiteral(", ")));
    }
    if (!left.dangerous.isEmpty()) {
        lines += Session::tr("The program ended twice while it opened unsaved work. It stays where it is: %1").arg(left.dangerous.join(QStringLiteral(", ")));
    }
    return lines.join(QLatin1Char(' '));
}

} // namespace

Session::Session(AskForFile askForFile, AskForChoice askForChoice, QObject* parent)
    : QObject(parent)
    , m_askForFile(std::move(askForFile))
    , m_askForChoice(std::move(askForChoice))
    , m_desktopIsDark(isDark(QApplication::palette()))
    , m_glSupport(probeOpenGl())
{
    computeInBackground();
    ui::applyTheme(*qApp, m_settings.theme(), m_desktopIsDark);
    qApp->installEventFilter(new KeyGuard(this));
}

Session::~Session()
{
    for (const QPointer<MainWindow>& window : std::as_const(m_windows)) {
        delete window;
    }
}

MainWindow* Session::openWindow()
{
    auto* window = new MainWindow(*this);
    m_windows.append(window);
    window->show();
    return window;
}

void Session::recover(std::vector<Recovery::Work>& works)
{
    for (Recovery::Work& work : works) {
        MainWindow* window = openWindow();
        window->recovery().adopt(std::move(work));
        window->raise();
        window->activateWindow();
        window->notify(tr("This is unsaved work from before the program ended unexpectedly. Save it to keep it."));
    }
}

void Session::start(const QStringList& files)
{
    Recovery::Leftovers left = Recovery::find(QDir(Settings::recoveryFolder()));
    const QString remark = remarkOn(left);
    for (const QString& file : files) {
        openWindow()->files().openFile(file);
    }
    recover(left.works); // in front of the files
    if (left.works.empty() && files.isEmpty()) {
        openWindow()->begin();
    }
    if (!remark.isEmpty()) {
        m_windows.constLast()->notify(remark);
    }
}

void Session::closeAll()
{
    for (const QPointer<MainWindow>& window : QList<QPointer<MainWindow>>(m_windows)) {
        if (window && !window->close()) {
            return;
        }
    }
}

void Session::finish(std::unique_ptr<ExportJob> job)
{
    ExportJob* kept = job.release();
    kept->setParent(this);
    const auto lock = std::make_shared<QEventLoopLocker>();
    const auto end = [kept, lock] { kept->deleteLater(); };
    connect(kept, &ExportJob::finished, kept, end);
    connect(kept, &ExportJob::cancelled, kept, end);
    connect(kept, &ExportJob::failed, kept, [this, end](const QString& message) {
        m_askForChoice(nullptr, {.name = QStringLiteral("exportFailedBox"), .title = tr("Export"), .text = tr("Export failed: %1").arg(message), .answers = {tr("Close")}});
        end();
    });
}

void Session::applyTheme(Theme theme)
{
    m_settings.setTheme(theme);
    ui::applyTheme(*qApp, theme, m_desktopIsDark);
}

} // namespace fumage::ui
