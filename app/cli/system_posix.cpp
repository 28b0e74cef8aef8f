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
            return {static_cast<std::size_t>(count), false, false, {}};
        }
        if (errno != EINTR && errno != EAGAIN) {
            return {0, false, errno == EPIPE, std::strerror(errno)};
        }
    }
    return {0, true, false, {}};
}

/// Writes to standard output; where nobody reads any more it fails with EPIPE instead of ending the program.
ssize_t writeWithoutSignal(std::span<const char> bytes)
{
    sigset_t pipe;
    sigset_t before;
    sigemptyset(&pipe);
    sigaddset(&pipe, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe, &before);
    const ssize_t count = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
    const int failure = errno;
    sigset_t pending;
    if (count < 0 && failure == EPIPE && sigpending(&pending) == 0 && sigismember(&pending, SIGPIPE) == 1) {
        int number = 0;
        sigwait(&pipe, &number);
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    errno = failure;
    return count;
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
    return whenReady(STDOUT_FILENO, POLLOUT,
        [&] { return writeWithoutSignal(bytes.first(std::min<std::size_t>(bytes.size(), PIPE_BUF))); });
}

} // namespace fumage::cli
