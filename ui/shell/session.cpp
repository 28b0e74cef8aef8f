#include "ui/shell/session.h"

#include "ui/document/recovery.h"
#include "ui/shell/key_guard.h"
#include "ui/shell/main_window.h"

#include "core/base/parallel.h"

#include <QApplication>

namespace fumage::ui {

Session::Session(AskForFile ask, QObject* parent)
    : QObject(parent)
    , m_askForFile(std::move(ask))
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

bool Session::recover()
{
    const std::vector<Recovery::Found> found = Recovery::take(QDir(Settings::recoveryFolder()));
    for (const Recovery::Found& work : found) {
        MainWindow* window = openWindow();
        window->document().load(work.preset, work.originalPath, true);
        window->notify(tr("This is unsaved work from before the program ended unexpectedly. Save it to keep it."));
    }
    return !found.empty();
}

void Session::start(const QStringList& files)
{
    const bool recovered = recover();
    for (const QString& file : files) {
        openWindow()->files().openFile(file);
    }
    if (!recovered && files.isEmpty()) {
        openWindow()->begin();
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

void Session::applyTheme(Theme theme)
{
    m_settings.setTheme(theme);
    ui::applyTheme(*qApp, theme, m_desktopIsDark);
}

} // namespace fumage::ui
