#include "core/system/child_process.h"

#include "core/system/child_errors.h"
#include "core/system/descriptor.h"
#include "core/system/system_text.h"
#include "core/base/windows_api.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <thread>

namespace fumage {

namespace {

constexpr DWORD kAskEvery = 100; ///< ms between two looks at whether to stop
constexpr DWORD kPipeBytes = 1U << 20U; ///< as much is on its way at most

Descriptor descriptorOf(HANDLE handle)
{
    return handle == nullptr ? Descriptor() : Descriptor(handle);
}

/// A word as programs take it out of their command line again. Source: the rules of CommandLineToArgvW.
std::wstring quoted(const std::wstring& word)
{
    std::wstring out = L"\"";
    std::size_t backslashes = 0;
    for (const wchar_t c : word) {
        // Only before a quote do backslashes stand for less than themselves.
        out.append(c == L'"' ? backslashes + 1 : 0, L'\\');
        out += c;
        backslashes = c == L'\\' ? backslashes + 1 : 0;
    }
    return out.append(backslashes, L'\\') + L'"';
}

std::wstring commandLine(const std::string& program, const std::vector<std::string>& arguments)
{
    std::wstring line = quoted(wideFrom(program));
    for (const std::string& argument : arguments) {
        line += L' ' + quoted(wideFrom(argument));
    }
    return line;
}

/// A pipe whose end for the other program alone is inherited, and whose other end does not wait.
struct Pipe {
    Descriptor ours;
    Descriptor theirs;

    [[nodiscard]] bool open(bool isInput)
    {
        static std::atomic<unsigned> count = 0;
        const std::wstring name =
            L"\\\\.\\pipe\\fumage-" + std::to_wstring(::GetCurrentProcessId()) + L"-" + std::to_wstring(count++);
        const DWORD direction = isInput ? PIPE_ACCESS_OUTBOUND : PIPE_ACCESS_INBOUND;
        ours = Descriptor(
            ::CreateNamedPipeW(name.c_str(), direction | FILE_FLAG_OVERLAPPED | FILE_FLAG_FIRST_PIPE_INSTANCE,
                PIPE_TYPE_BYTE | PIPE_WAIT | PIPE_REJECT_REMOTE_CLIENTS, 1, kPipeBytes, kPipeBytes, 0, nullptr));
        SECURITY_ATTRIBUTES inherited{sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE};
        theirs = ours ? Descriptor(::CreateFileW(
                     name.c_str(), isInput ? GENERIC_READ : GENERIC_WRITE, 0, &inherited, OPEN_EXISTING, 0, nullptr))
                      : Descriptor();
        return static_cast<bool>(theirs);
    }
};

/// Reading or writing that goes on by itself.
class Transfer {
public:
    explicit Transfer(HANDLE pipe)
        : m_pipe(pipe)
        , m_done(descriptorOf(::CreateEventW(nullptr, TRUE, FALSE, nullptr)))
    {
        m_state.hEvent = m_done.get();
    }
    ~Transfer()
    {
        if (m_isUnderWay) {
            ::CancelIoEx(m_pipe, &m_state);
            static_cast<void>(result());
        }
    }
    Transfer(const Transfer&) = delete;
    Transfer& operator=(const Transfer&) = delete;
    Transfer(Transfer&&) = delete;
    Transfer& operator=(Transfer&&) = delete;

    /// @return whether it goes on or is done; if not, the other end is gone
    bool write(std::span<const std::byte> bytes)
    {
        return began(::WriteFile(m_pipe, bytes.data(),
            static_cast<DWORD>(std::min<std::size_t>(bytes.size(), kPipeBytes)), nullptr, &m_state));
    }
    bool read(std::span<char> room)
    {
        return began(::ReadFile(m_pipe, room.data(), static_cast<DWORD>(room.size()), nullptr, &m_state));
    }

    /// Whether it is done; waits a little.
    [[nodiscard]] bool isDone() { return ::WaitForSingleObject(m_done.get(), kAskEvery) == WAIT_OBJECT_0; }

    /// @return how many bytes; 0 where the other end is gone. Waits
    [[nodiscard]] std::size_t result()
    {
        DWORD count = 0;
        m_isUnderWay = false;
        return ::GetOverlappedResult(m_pipe, &m_state, &count, TRUE) != 0 ? count : 0;
    }

private:
    bool began(BOOL done)
    {
        m_isUnderWay = done != 0 || ::GetLastError() == ERROR_IO_PENDING;
        return m_isUnderWay;
    }

    HANDLE m_pipe;
    Descriptor m_done;
    OVERLAPPED m_state{};
    bool m_isUnderWay = false;
};

/// Starts a program that inherits two handles and nothing else. @return 0 with the process, or the error of what failed
DWORD spawn(std::wstring line, HANDLE input, HANDLE messages, Descriptor& process)
{
    std::array<HANDLE, 2> inherited{input, messages};
    SIZE_T size = 0;
    ::InitializeProcThreadAttributeList(nullptr, 1, 0, &size);
    std::vector<std::byte> room(size);
    STARTUPINFOEXW start{};
    start.StartupInfo.cb = sizeof(start);
    start.StartupInfo.dwFlags = STARTF_USESTDHANDLES;
    start.StartupInfo.hStdInput = input;
    start.StartupInfo.hStdOutput = messages;
    start.StartupInfo.hStdError = messages;
    start.lpAttributeList = reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(room.data());
    if (::InitializeProcThreadAttributeList(start.lpAttributeList, 1, 0, &size) == 0) {
        return ::GetLastError();
    }
    ::UpdateProcThreadAttribute(start.lpAttributeList, 0, PROC_THREAD_ATTRIBUTE_HANDLE_LIST, inherited.data(),
        sizeof(inherited), nullptr, nullptr);
    PROCESS_INFORMATION information{};
    const BOOL started = ::CreateProcessW(nullptr, line.data(), nullptr, nullptr, TRUE,
        EXTENDED_STARTUPINFO_PRESENT | CREATE_NO_WINDOW, nullptr, nullptr, &start.StartupInfo, &information);
    const DWORD failure = started != 0 ? 0 : ::GetLastError();
    ::DeleteProcThreadAttributeList(start.lpAttributeList);
    process = descriptorOf(information.hProcess);
    const Descriptor thread = descriptorOf(information.hThread);
    return failure;
}

} // namespace

class ChildProcess::Running {
public:
    Running(std::string program, Descriptor process, Descriptor input, Descriptor messages)
        : m_program(std::move(program))
        , m_process(std::move(process))
        , m_input(std::move(input))
        , m_messages(std::move(messages))
        , m_listener([this] { listen(); })
    {
    }
    ~Running()
    {
        m_input = {};
        ::TerminateProcess(m_process.get(), 1); // does nothing where it has ended
        if (m_listener.joinable()) {
            m_listener.join();
        }
        ::WaitForSingleObject(m_process.get(), INFINITE);
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    Running(Running&&) = delete;
    Running& operator=(Running&&) = delete;

    [[nodiscard]] Status write(std::span<const std::byte> bytes, const std::stop_token& stop)
    {
        Transfer transfer(m_input.get());
        while (!bytes.empty()) {
            if (!transfer.write(bytes)) {
                return failure();
            }
            while (!transfer.isDone()) {
                if (stop.stop_requested()) {
                    return childCancelled();
                }
            }
            const std::size_t count = transfer.result();
            if (count == 0) {
                return failure();
            }
            bytes = bytes.subspan(count);
        }
        return stop.stop_requested() ? Status(childCancelled()) : Done{};
    }

    [[nodiscard]] Status finish(const std::stop_token& stop)
    {
        m_input = {};
        while (::WaitForSingleObject(m_process.get(), kAskEvery) != WAIT_OBJECT_0) {
            if (stop.stop_requested()) {
                return childCancelled();
            }
        }
        DWORD code = 1;
        ::GetExitCodeProcess(m_process.get(), &code);
        return code == 0 ? Status(Done{}) : failure();
    }

private:
    /// Keeps what the program says, until it says no more.
    void listen()
    {
        std::array<char, kMaxChildSays> part{};
        for (std::size_t count = 1; count > 0;) {
            Transfer transfer(m_messages.get());
            count = transfer.read(part) ? transfer.result() : 0;
            keepEnd(m_said, {part.data(), count});
        }
    }

    /// Waits for its last words; of one that takes nothing more and does not end, not for long.
    [[nodiscard]] Error failure()
    {
        constexpr DWORD kGrace = 2000; // ms
        m_input = {};
        if (::WaitForSingleObject(m_process.get(), kGrace) != WAIT_OBJECT_0) {
            ::TerminateProcess(m_process.get(), 1);
        }
        if (m_listener.joinable()) {
            m_listener.join();
        }
        return childFailed(m_program, m_said);
    }

    std::string m_program;
    Descriptor m_process;
    Descriptor m_input;
    Descriptor m_messages;
    std::string m_said; ///< the listener's until it has been joined
    std::thread m_listener; ///< last: it uses the others
};

ChildProcess::ChildProcess(std::unique_ptr<Running> running)
    : m_running(std::move(running))
{
}

ChildProcess::~ChildProcess() = default;
ChildProcess::ChildProcess(ChildProcess&& other) noexcept = default;

Result<ChildProcess> ChildProcess::start(const std::string& program, const std::vector<std::string>& arguments)
{
    Pipe input;
    Pipe messages;
    Descriptor process;
    const bool isOpen = input.open(true) && messages.open(false);
    const DWORD failure = isOpen
        ? spawn(commandLine(program, arguments), input.theirs.get(), messages.theirs.get(), process)
        : ::GetLastError();
    if (failure != 0) {
        return childNotStarted(static_cast<int>(failure), program, systemText(failure));
    }
    return ChildProcess(
        std::make_unique<Running>(program, std::move(process), std::move(input.ours), std::move(messages.ours)));
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
