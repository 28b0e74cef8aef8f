#include "app/cli/system.h"

#include "app/cli/interruption.h"

#include "core/system/descriptor.h"
#include "core/system/system_text.h"
#include "core/base/windows_api.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <stop_token>
#include <utility>

#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <shellapi.h>

namespace fumage::cli {

namespace {

constexpr std::size_t kMaxAtOnce = std::size_t{1} << 16U;

/// What may wait for ever, and what came of it.
struct Transfer {
    std::function<Transferred()> act;
    Transferred result;
};

/// @param share a std::shared_ptr<Transfer> on the heap: whoever waits may be gone before the end
unsigned __stdcall transferOnThread(void* share)
{
    const std::unique_ptr<std::shared_ptr<Transfer>> transfer(static_cast<std::shared_ptr<Transfer>*>(share));
    (*transfer)->result = (*transfer)->act();
    return 0;
}

/// Does what may wait for ever on a thread of its own, which ends with the program where the user interrupts first.
/// It is Windows's own thread, and what is waited for is its end: an event that a detached std::thread of mingw set was
/// seen to get lost.
Transferred unlessInterrupted(std::function<Transferred()> act)
{
    constexpr DWORD kLookMs = 100; // how long an interruption may go unseen
    const auto transfer = std::make_shared<Transfer>(Transfer{std::move(act), {}});
    auto share = std::make_unique<std::shared_ptr<Transfer>>(transfer);
    const Descriptor thread(
        reinterpret_cast<HANDLE>(_beginthreadex(nullptr, 0, &transferOnThread, share.get(), 0, nullptr)));
    if (thread.get() == nullptr) {
        return transfer->act(); // and waits as long as it takes
    }
    (void)share.release();
    const std::stop_token stop = interruption();
    while (::WaitForSingleObject(thread.get(), kLookMs) == WAIT_TIMEOUT) {
        if (stop.stop_requested()) {
            return {0, true, false, {}};
        }
    }
    return transfer->result;
}

} // namespace

StandardStreams::StandardStreams()
    : m_before(::GetConsoleOutputCP())
{
    for (std::FILE* stream : {stdin, stdout, stderr}) {
        _setmode(_fileno(stream), _O_BINARY);
    }
    ::SetConsoleOutputCP(CP_UTF8);
    // So that the line of a progress bar can be cleared.
    const HANDLE terminal = ::GetStdHandle(STD_ERROR_HANDLE);
    DWORD mode = 0;
    if (::GetConsoleMode(terminal, &mode) != 0) {
        ::SetConsoleMode(terminal, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
    }
}

StandardStreams::~StandardStreams()
{
    ::SetConsoleOutputCP(m_before);
}

std::vector<std::string> argumentsOf(int /*argc*/, char** /*argv*/)
{
    // What main() is given has lost all letters that the system's old code page lacks.
    int count = 0;
    wchar_t** const words = ::CommandLineToArgvW(::GetCommandLineW(), &count);
    std::vector<std::string> arguments;
    for (int i = 1; i < count; ++i) {
        arguments.push_back(utf8From(words[i]));
    }
    ::LocalFree(words);
    return arguments;
}

bool isErrorOnTerminal()
{
    return _isatty(_fileno(stderr)) != 0;
}

Transferred readSome(std::span<char> room)
{
    const auto buffer = std::make_shared<std::vector<char>>(std::min(room.size(), kMaxAtOnce));
    const Transferred result = unlessInterrupted([buffer]() -> Transferred {
        DWORD count = 0;
        const bool isRead = ::ReadFile(::GetStdHandle(STD_INPUT_HANDLE), buffer->data(),
                                static_cast<DWORD>(buffer->size()), &count, nullptr)
            != 0;
        const DWORD failure = isRead ? ERROR_SUCCESS : ::GetLastError();
        const bool isEnd = failure == ERROR_BROKEN_PIPE || failure == ERROR_HANDLE_EOF; // whoever wrote has ended
        return {
            count, failure == ERROR_OPERATION_ABORTED, false, isRead || isEnd ? std::string() : systemText(failure)};
    });
    std::copy_n(buffer->data(), result.count, room.data());
    return result;
}

Transferred writeSome(std::span<const char> bytes)
{
    const auto buffer = std::make_shared<std::vector<char>>(
        bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(std::min(bytes.size(), kMaxAtOnce)));
    return unlessInterrupted([buffer]() -> Transferred {
        DWORD count = 0;
        const bool isWritten = ::WriteFile(::GetStdHandle(STD_OUTPUT_HANDLE), buffer->data(),
                                   static_cast<DWORD>(buffer->size()), &count, nullptr)
            != 0;
        const DWORD failure = isWritten ? ERROR_SUCCESS : ::GetLastError();
        return {count, false, failure == ERROR_BROKEN_PIPE || failure == ERROR_NO_DATA,
            isWritten ? std::string() : systemText(failure)};
    });
}

} // namespace fumage::cli
