#include "ui/shell/end_signals.h"

#include "core/base/windows_api.h"

#include <QMetaObject>

#include <atomic>
#include <csignal>
#include <utility>

namespace fumage::ui {

namespace {

/// Whom the handler tells; null where nobody is there (any more). Only a global reaches a handler.
std::atomic<EndSignals*> s_told = nullptr; // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)
std::function<void(int)> s_end; // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

/// Called on a thread of its own.
BOOL WINAPI takeEvent(DWORD event)
{
    EndSignals* told = s_told.exchange(nullptr);
    if (told == nullptr) {
        return FALSE; // whoever asks twice has it ended at once
    }
    const bool isBreak = event == CTRL_C_EVENT || event == CTRL_BREAK_EVENT;
    QMetaObject::invokeMethod(
        told, [number = isBreak ? SIGINT : SIGTERM] { s_end(number); }, Qt::QueuedConnection);
    if (!isBreak) {
        // The console goes away, and the program with it as soon as this returns: it may end by itself for as long as
        // Windows waits.
        ::Sleep(INFINITE);
    }
    return TRUE;
}

} // namespace

EndSignals::EndSignals(std::function<void(int)> end, QObject* parent)
    : QObject(parent)
{
    s_end = std::move(end);
    s_told = this;
    ::SetConsoleCtrlHandler(takeEvent, TRUE);
}

EndSignals::~EndSignals()
{
    ::SetConsoleCtrlHandler(takeEvent, FALSE);
    s_told = nullptr;
}

} // namespace fumage::ui
