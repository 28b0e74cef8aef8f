#include "core/system/child_process.h"

#include "core/system/child_errors.h"
#include "core/system/descriptor.h"

#include <array>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ; // NOLINT(readability-redundant-declaration): not every system's headers have it

namespace fumage {

namespace {

constexpr int kAskEvery = 100; ///< ms between two looks at whether to stop

#ifdef __APPLE__
constexpr int kNoSignal = 0;

int connect(std::array<int, 2>& ends)
{
    constexpr int kOn = 1;
    const int made = ::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data());
    for (const int end : ends) {
        static_cast<void>(::fcntl(end, F_SETFD, FD_CLOEXEC));
        static_cast<void>(::setsockopt(end, SOL_SOCKET, SO_NOSIGPIPE, &kOn, sizeof(kOn)));
    }
    return made;
}
#else
constexpr int kNoSignal = MSG_NOSIGNAL;

int connect(std::array<int, 2>& ends)
{
    return ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data());
}
#endif

/// Two ends of a connection that other programs do not inherit.
struct Connection {
    Descriptor ours;
    Descriptor theirs;

    /// @return 0, or the errno of what failed
    [[nodiscard]] int open()
    {
        std::array<int, 2> ends{-1, -1};
        if (connect(ends) != 0) {
            return errno;
        }
        ours = Descriptor(ends[0]);
        theirs = Descriptor(ends[1]);
        return 0;
    }
};

/// @return 0 with the process, or the errno of what failed
int spawn(const std::string& program, const std::vector<std::string>& arguments, int input, int messages, pid_t& id)
{
    std::vector<char*> words;
    words.push_back(
        const_cast<char*>(program.c_str())); // NOLINT(cppcoreguidelines-pro-type-const-cast): it writes to none
    for (const std::string& argument : arguments) {
        words.push_back(const_cast<char*>(argument.c_str())); // NOLINT(cppcoreguidelines-pro-type-const-cast)
    }
    words.push_back(nullptr);
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&files, messages, STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&files, messages, STDERR_FILENO);
    const int failure = ::posix_spawnp(&id, program.c_str(), &files, nullptr, words.data(), environ);
    ::posix_spawn_file_actions_destroy(&files);
    return failure;
}

} // namespace

class ChildProcess::Running {
public:
    Running(std::string program, pid_t id, Descriptor input, Descriptor messages)
        : m_program(std::move(program))
        , m_id(id)
        , m_input(std::move(input))
        , m_messages(std::move(messages))
    {
    }
    ~Running()
    {
        if (m_id >= 0) {
            ::kill(m_id, SIGKILL);
            reap();
        }
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    Running(Running&&) = delete;
    Running& operator=(Running&&) = delete;

    [[nodiscard]] Status write(std::span<const std::byte> bytes, const std::stop_token& stop);
    [[nodiscard]] Status finish(const std::stop_token& stop);

private:
    /// Reads what the program has said. @return whether it may say more
    bool listen();
    /// Waits until it ends. @return what waitpid() says
    int reap();

    std::string m_program;
    pid_t m_id = -1; ///< -1: it has ended
    Descriptor m_input;
    Descriptor m_messages;
    std::string m_said;
};

bool ChildProcess::Running::listen()
{
    std::array<char, kMaxChildSays> part{};
    const ssize_t count = ::recv(m_messages.get(), part.data(), part.size(), MSG_DONTWAIT);
    if (count > 0) {
        keepEnd(m_said, {part.data(), static_cast<std::size_t>(count)});
    }
    return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
}

int ChildProcess::Running::reap()
{
    int status = 0;
    while (::waitpid(m_id, &status, 0) < 0 && errno == EINTR) { }
    m_id = -1;
    return status;
}

Status ChildProcess::Running::write(std::span<const std::byte> bytes, const std::stop_token& stop)
{
    while (!bytes.empty()) {
        if (stop.stop_requested()) {
            return childCancelled();
        }
        std::array<pollfd, 2> ready{{{m_input.get(), POLLOUT, 0}, {m_messages.get(), POLLIN, 0}}};
        if (::poll(ready.data(), ready.size(), kAskEvery) < 0 && errno != EINTR) {
            return childFailed(m_program, m_said);
        }
        const bool isThere = ready[1].revents == 0 || listen();
        const ssize_t count = ::send(m_input.get(), bytes.data(), bytes.size(), MSG_DONTWAIT | kNoSignal);
        if (count >= 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(count));
        } else if (!isThere || (errno != EAGAIN && errno != EINTR)) {
            while (listen() && errno != EAGAIN) { // its last words
            }
            return childFailed(m_program, m_said);
        }
    }
    return Done{};
}

Status ChildProcess::Running::finish(const std::stop_token& stop)
{
    m_input = {};
    while (true) {
        if (stop.stop_requested()) {
            return childCancelled();
        }
        pollfd ready{m_messages.get(), POLLIN, 0};
        if (::poll(&ready, 1, kAskEvery) > 0 && !listen()) {
            break;
        }
    }
    const int status = reap();
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Status(Done{}) : childFailed(m_program, m_said);
}

ChildProcess::ChildProcess(std::unique_ptr<Running> running)
    : m_running(std::move(running))
{
}

ChildProcess::~ChildProcess() = default;
ChildProcess::ChildProcess(ChildProcess&& other) noexcept = default;

Result<ChildProcess> ChildProcess::start(const std::string& program, const std::vector<std::string>& arguments)
{
    Connection input;
    Connection messages;
    pid_t id = -1;
    int failure = input.open();
    failure = failure != 0 ? failure : messages.open();
    failure = failure != 0 ? failure : spawn(program, arguments, input.theirs.get(), messages.theirs.get(), id);
    if (failure != 0) {
        return childNotStarted(failure, program, std::strerror(failure));
    }
    return ChildProcess(std::make_unique<Running>(program, id, std::move(input.ours), std::move(messages.ours)));
}

Status ChildProcess::write(std::span<const std::byte> bytes, const std::stop_token& stop)
{
    return m_running->write(bytes, stop);
}

Status ChildProcess::finish(const std::stop_token& stop)
{
    return m_running->finish(stop);
}

} // namespace fumage
