#include "ui/shell/app_services.h"

#include "ui/presets/thumbnail_store.h"
#include "ui/shell/shortcut_filter.h"
#include "ui/widgets/input_guard.h"
#include "ui/widgets/plain_text.h"
#include "ui/widgets/window_keeper.h"

#include "core/base/heap.h"

#include <QApplication>
#include <QDir>

namespace fumage::ui {

namespace {

/// Two windows with what stands in while theirs is baked.
constexpr std::size_t kKeptAirs = 4;

} // namespace

AppServices::AppServices(AskForFile askForFile, AskForChoice askForChoice, QObject* parent)
    : QObject(parent)
    , m_allThreads(static_cast<int>(parallelThreads()))
    , m_askForFile(std::move(askForFile))
    , m_askForChoice(std::move(askForChoice))
    , m_desktopIsDark(isDark(QApplication::palette()))
    , m_glSupport(probeOpenGl())
    , m_exports(QDir(Settings::queueFolder()), std::make_shared<AirCache>(kKeptAirs))
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
    connect(&m_settings, &Settings::threadsChanged, this, &AppServices::limitThreads);
    limitThreads(m_settings.threads());
    connect(&m_settings, &Settings::cacheMegabytesChanged, this, &AppServices::pruneCache);
    pruneCache(m_settings.cacheMegabytes());
    ui::applyTheme(*qApp, m_settings.theme(), m_desktopIsDark);
    qApp->installEventFilter(new ShortcutFilter(this));
    qApp->installEventFilter(new PlainLabels(this));
    qApp->installEventFilter(new InputGuard(this));
    qApp->installEventFilter(new WindowKeeper(this));
}

void AppServices::limitThreads(int threads)
{
    m_threads.reset();
    if (threads > 0) {
        m_threads.emplace(threads);
    }
}

void AppServices::pruneCache(int megabytes)
{
    constexpr qint64 kMegabyte = 1024 * 1024;
    m_pruning.ask([bytes = megabytes * kMegabyte](const AsyncRequest::Report&,
                      const std::stop_token&) { ThumbnailStore(ThumbnailStore::usualFolder()).prune(bytes); },
        [](const Error&) {});
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
