#include "app/cli/system.h"

#include "app/cli/interruption.h"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>

#include <poll.h>
#include <unistd.h>

namespace fumage::cli {

namespace {

/// Waits until a descriptor can be used. @return false where the user has interrupted
bool waitFor(int descriptor, short event)
{
    constexpr int kLookMs = 100; // how long an interruption may go unseen
    const std::stop_token stop = interruption();
    pollfd waited{descriptor, event, 0};
    while (!stop.stop_requested()) {
        if (::poll(&waited, 1, kLookMs) != 0) {
            return true; // or an error, which reading and writing will say
        }
    }
    return false;
}

/// Does something when a descriptor can be used, until it is done or fails.
template <class Act>
Transferred whenReady(int descriptor, short event, const Act& act)
{
    while (waitFor(descriptor, event)) {
        const ssize_t count = act();
        if (count >= 0) {
            return {static_cast<std::size_t>(count), false, {}};
        }
        if (errno != EINTR && errno != EAGAIN) {
            return {0, false, std::strerror(errno)};
        }
    }
    return {0, true, {}};
}

} // namespace

StandardStreams::StandardStreams()
{
    std::signal(SIGXFSZ, SIG_IGN); // writing says it too, and then what was begun can be cleared away
}

StandardStreams::~StandardStreams() = default;

std::vector<std::string> argumentsOf(int argc, char** argv)
{
    return {argv + std::min(argc, 1), argv + argc};
}

bool isErrorOnTerminal()
{
    return ::isatty(STDERR_FILENO) != 0;
}

Transferred readSome(std::span<char> room)
{
    return whenReady(STDIN_FILENO, POLLIN, [&] { return ::read(STDIN_FILENO, room.data(), room.size()); });
}

Transferred writeSome(std::span<const char> bytes)
{
    // A pipe that can be written takes this much without making us wait for its reader.
    return whenReady(STDOUT_FILENO, POLLOUT, [&] { return ::write(STDOUT_FILENO, bytes.data(), std::min<std::size_t>(bytes.size(), PIPE_BUF)); });
}

} // namespace fumage::cli
