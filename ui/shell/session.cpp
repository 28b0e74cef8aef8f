#include "ui/shell/session.h"

#include "ui/shell/main_window.h"
#include "ui/widgets/message_bar.h"

#include <algorithm>

#include <QDir>
#include <QEventLoopLocker>

namespace fumage::ui {

namespace {

/// What is to be known of copies of unsaved work that are not opened; empty: nothing.
QString remarkOn(const Recovery::Leftovers& left)
{
    QStringList lines;
    if (!left.unreadable.isEmpty()) {
        lines += Session::tr("A copy of unsaved work cannot be read. It stays where it is: %1")
                     .arg(left.unreadable.join(QStringLiteral(", ")));
    }
    if (!left.dangerous.isEmpty()) {
        lines += Session::tr("The program ended twice while it opened unsaved work. It stays where it is: %1")
                     .arg(left.dangerous.join(QStringLiteral(", ")));
    }
    return lines.join(QLatin1Char(' '));
}

} // namespace

Session::Session(AskForFile askForFile, AskForChoice askForChoice, QObject* parent)
    : AppServices(std::move(askForFile), std::move(askForChoice), parent)
{
    connectExports();
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
        window->notices().sayRecovered();
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
    offerExports();
    if (!remark.isEmpty()) {
        m_windows.constLast()->messages().say(QStringLiteral("notice.left"), remark, {{tr("Close"), {}}});
    }
}

void Session::keepWork()
{
    for (const QPointer<MainWindow>& window : std::as_const(m_windows)) {
        if (window) {
            window->recovery().keep();
        }
    }
}

void Session::leaveWork()
{
    for (const QPointer<MainWindow>& window : std::as_const(m_windows)) {
        if (window) {
            window->recovery().leave();
        }
    }
}

void Session::end()
{
    m_isEnding = true;
    for (const QPointer<MainWindow>& window : std::as_const(m_windows)) {
        if (window && window->isVisible()) {
            window->recovery().leave();
        }
    }
}

void Session::closeAll()
{
    for (const QPointer<MainWindow>& window : QList<QPointer<MainWindow>>(m_windows)) {
        if (window && window->isVisible() && window->exports().isBusy()) {
            // It does not refuse: it cannot be asked yet. Nor can those after it, of which the last is asked for all.
            connect(&window->exports(), &ExportController::rested, this, &Session::closeAll,
                Qt::ConnectionType(Qt::QueuedConnection | Qt::SingleShotConnection | Qt::UniqueConnection));
            return;
        }
        if (window && !window->close()) {
            return;
        }
    }
}

bool Session::isLast(const QWidget& window) const
{
    return std::none_of(m_windows.begin(), m_windows.end(),
        [&](const QPointer<MainWindow>& other) { return other && other != &window && other->isVisible(); });
}

bool Session::mayClose(QWidget& window)
{
    if (exports().active() == 0 || !isLast(window)) {
        return true;
    }
    const int answer = askForChoice()(&window,
        {.name = QStringLiteral("exportRunsBox"),
            .title = tr("Exports"),
            .text = tr("Exports still running or waiting: %1").arg(exports().active()),
            .answers = {tr("Finish in the background and close"), tr("Stop them and close"), tr("Cancel")}});
    constexpr int kFinish = 0;
    constexpr int kStop = 1;
    if (answer == kStop) {
        exports().stopAll();
    } else if (answer == kFinish && exports().active() > 0) { // while one thought about it they may have ended
        m_untilExported = std::make_shared<QEventLoopLocker>();
    }
    return answer == kFinish || answer == kStop;
}

void Session::connectExports()
{
    connect(&exports(), &ExportQueue::ended, this, [this](quint64 id) {
        const QueuedExport* one = exports().find(id);
        if (m_untilExported && one != nullptr && one->state == ExportState::Failed) { // there is no window that says it
            askForChoice()(nullptr,
                {.name = QStringLiteral("exportFailedBox"),
                    .title = tr("Export"),
                    .text = tr("Export failed: %1").arg(one->told),
                    .answers = {tr("Close")}});
        }
    });
    connect(&exports(), &ExportQueue::emptied, this, [this] { m_untilExported.reset(); });
}

void Session::offerExports()
{
    const QStringList unreadable = exports().takeLeftovers();
    MainWindow* window = m_windows.constLast();
    if (!unreadable.isEmpty()) {
        window->notify(tr("A list of exports cannot be read. It stays where it is: %1")
                           .arg(unreadable.join(QStringLiteral(", "))));
    }
    if (const int left = exports().held(); left > 0) {
        QMetaObject::invokeMethod(
            &window->docks(), &Docks::showQueue, Qt::QueuedConnection); // once the panels have their places
        QStringList said{
            tr("Exports that were not finished when the program ended: %1. The panel Exports starts or removes them.")
                .arg(left)};
        if (const int more = exports().crowdedOut(); more > 0) {
            said += tr("The list has no room for %1 more, which come when the program starts again.").arg(more);
        }
        window->notify(said.join(QLatin1Char(' ')));
    }
}

} // namespace fumage::ui
