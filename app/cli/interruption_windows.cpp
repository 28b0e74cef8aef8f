#include "app/cli/interruption.h"

#include "core/base/windows_api.h"

#include <atomic>

namespace fumage::cli {

namespace {

std::stop_source& source()
{
    static std::stop_source stop;
    return stop;
}

/// Called on a thread of its own.
BOOL WINAPI takeEvent(DWORD event)
{
    static std::atomic<bool> s_wasAsked = false;
    const bool again = s_wasAsked.exchange(true);
    source().request_stop();
    if (event != CTRL_C_EVENT && event != CTRL_BREAK_EVENT) {
        // The terminal goes away, and the program with it as soon as this returns: it may end by itself for as long as
        // Windows waits.
        ::Sleep(INFINITE);
    }
    return again ? FALSE : TRUE; // whoever asks twice has it ended at once
}

} // namespace

std::stop_token interruption()
{
    static const bool s_listens = ::SetConsoleCtrlHandler(takeEvent, TRUE) != 0;
    static_cast<void>(s_listens);
    return source().get_token();
}

} // namespace fumage::cli
