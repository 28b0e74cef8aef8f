#include "core/base/child_process.h"

#include "core/base/text.h"

#include <array>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fumage {

namespace {

constexpr std::size_t kMostSaid = 4096; ///< the end of what a program says is what it stumbled over
constexpr int kAskEvery = 100; ///< ms between two looks at whether to stop

/// Two ends of a connection that other programs do not inherit.
struct Connection {
    Descriptor ours;
    Descriptor theirs;

    /// @return 0, or the errno of what failed
    [[nodiscard]] int open()
    {
        std::array<int, 2> ends{-1, -1};
        if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
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
    words.push_back(const_cast<char*>(program.c_str())); // NOLINT(cppcoreguidelines-pro-type-const-cast): it writes to none
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

Error cancelled()
{
    return {ErrorCode::Cancelled, said("the video was cancelled"), {}, {}};
}

} // namespace

Result<ChildProcess> ChildProcess::start(const std::string& program, const std::vector<std::string>& arguments)
{
    Connection input;
    Connection messages;
    pid_t id = -1;
    int failure = input.open();
    failure = failure != 0 ? failure : messages.open();
    failure = failure != 0 ? failure : spawn(program, arguments, input.theirs.get(), messages.theirs.get(), id);
    if (failure != 0) {
        const ErrorCode code = failure == EACCES ? ErrorCode::PermissionDenied : ErrorCode::FileNotFound;
        return Error{code, said("the program cannot be started: %1", std::strerror(failure)), program, {}};
    }
    return ChildProcess(program, id, std::move(input.ours), std::move(messages.ours));
}

ChildProcess::ChildProcess(std::string program, pid_t id, Descriptor input, Descriptor messages)
    : m_program(std::move(program))
    , m_id(id)
    , m_input(std::move(input))
    , m_messages(std::move(messages))
{
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : m_program(std::move(other.m_program))
    , m_id(std::exchange(other.m_id, -1))
    , m_input(std::move(other.m_input))
    , m_messages(std::move(other.m_messages))
    , m_said(std::move(other.m_said))
{
}

ChildProcess::~ChildProcess()
{
    if (m_id >= 0) {
        ::kill(m_id, SIGKILL);
        reap();
    }
}

bool ChildProcess::listen()
{
    std::array<char, kMostSaid> part{};
    const ssize_t count = ::recv(m_messages.get(), part.data(), part.size(), MSG_DONTWAIT);
    if (count > 0) {
        m_said.append(part.data(), static_cast<std::size_t>(count));
        m_said.erase(0, m_said.size() - std::min(m_said.size(), kMostSaid));
    }
    return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
}

int ChildProcess::reap()
{
    int status = 0;
    while (::waitpid(m_id, &status, 0) < 0 && errno == EINTR) {
    }
    m_id = -1;
    return status;
}

Error ChildProcess::failure() const
{
    const std::string_view reason = trimmed(m_said);
    return {ErrorCode::WriteFailed, reason.empty() ? said("the program ended by itself") : said("the program failed: %1", std::string(reason)), m_program, {}};
}

Status ChildProcess::write(std::span<const std::byte> bytes, const std::stop_token& stop)
{
    while (!bytes.empty()) {
        if (stop.stop_requested()) {
            return cancelled();
        }
        std::array<pollfd, 2> ready{{{m_input.get(), POLLOUT, 0}, {m_messages.get(), POLLIN, 0}}};
        if (::poll(ready.data(), ready.size(), kAskEvery) < 0 && errno != EINTR) {
            return failure();
        }
        const bool isThere = ready[1].revents == 0 || listen();
        const ssize_t count = ::send(m_input.get(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
        if (count >= 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(count));
        } else if (!isThere || (errno != EAGAIN && errno != EINTR)) {
            while (listen() && errno != EAGAIN) { // its last words
            }
            return failure();
        }
    }
    return Done{};
}

Status ChildProcess::finish(const std::stop_token& stop)
{
    m_input = {};
    while (true) {
        if (stop.stop_requested()) {
            return cancelled();
        }
        pollfd ready{m_messages.get(), POLLIN, 0};
        if (::poll(&ready, 1, kAskEvery) > 0 && !listen()) {
            break;
        }
    }
    const int status = reap();
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Status(Done{}) : failure();
}

} // namespace fumage
