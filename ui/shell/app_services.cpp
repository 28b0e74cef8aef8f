#include "ui/shell/app_services.h"

#include "ui/shell/shortcut_filter.h"
#include "ui/widgets/input_guard.h"
#include "ui/widgets/plain_text.h"
#include "ui/widgets/window_keeper.h"

#include "core/base/heap.h"
#include "core/base/parallel.h"

#include <QApplication>
#include <QDir>

namespace fumage::ui {

AppServices::AppServices(AskForFile askForFile, AskForChoice askForChoice, QObject* parent)
    : QObject(parent)
    , m_askForFile(std::move(askForFile))
    , m_askForChoice(std::move(askForChoice))
    , m_desktopIsDark(isDark(QApplication::palette()))
    , m_glSupport(probeOpenGl())
    , m_exports(QDir(Settings::queueFolder()))
{
    // after a burst of changes: what is given back in the middle of one is asked for again at once
    constexpr int kThriftMs = 2000;
    m_thrift.setSingleShot(true);
    m_thrift.setInterval(kThriftMs);
    connect(&m_thrift, &QTimer::timeout, this, [this] {
        // It takes some tens of milliseconds, in which others may wait for memory, but not the window.
        m_giving.ask(
            [](const AsyncRequest::Report&, const std::stop_token&) { giveBackMemory(); }, [](const Error&) {});
    });
    computeInBackground();
    ui::applyTheme(*qApp, m_settings.theme(), m_desktopIsDark);
    qApp->installEventFilter(new ShortcutFilter(this));
    qApp->installEventFilter(new PlainLabels(this));
    qApp->installEventFilter(new InputGuard(this));
    qApp->installEventFilter(new WindowKeeper(this));
}

void AppServices::giveBackMemorySoon()
{
    m_thrift.start();
}

void AppServices::applyTheme(Theme theme)
{
    m_settings.setTheme(theme);
    ui::applyTheme(*qApp, theme, m_desktopIsDark);
}

} // namespace fumage::ui
