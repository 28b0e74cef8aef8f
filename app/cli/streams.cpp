#include "app/cli/streams.h"

#include "app/cli/interruption.h"

#include "core/base/file.h"
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>
#include <iostream>

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

std::atomic<bool> hearsOpenJd = false; // set before any work begins

Error interrupted()
{
    return {ErrorCode::Cancelled, said("interrupted"), {}, {}};
}

bool passes(int number)
{
    return number == EINTR || number == EAGAIN;
}

} // namespace

void beQuiet()
{
    std::clog.rdbuf(nullptr);
}

void talkToOpenJd()
{
    hearsOpenJd = true;
}

bool talksToOpenJd()
{
    return hearsOpenJd;
}

void tellOpenJd(std::string_view what, const std::string& text)
{
    if (hearsOpenJd) {
        std::cout << "openjd_" << what << ": " << printable(text) << std::endl;
    }
}

void warn(const std::string& text)
{
    std::clog << "fumage-cli: warning: " << printable(text) << std::endl;
}

void tell(const std::string& text)
{
    std::clog << "fumage-cli: " << printable(text) << std::endl;
}

void tellWritten(int count, const std::filesystem::path& first, const std::filesystem::path& last)
{
    tell(count == 1 ? "wrote " + first.string() : "wrote " + std::to_string(count) + " files, " + first.string() + " to " + last.string());
}

void tellWritten(const std::filesystem::path& output, const FrameRange& frames, std::string_view ending)
{
    const auto fileOf = [&](int index) { return framePath(output, frames, ending, frames.at(index)); };
    tellWritten(frames.count(), fileOf(0), fileOf(frames.count() - 1));
}

Result<std::string> readStandardInput(std::size_t mostBytes)
{
    std::string text;
    std::array<char, 1U << 16U> buffer{};
    while (text.size() <= mostBytes) {
        if (!waitFor(STDIN_FILENO, POLLIN)) {
            return interrupted();
        }
        const ssize_t count = ::read(STDIN_FILENO, buffer.data(), buffer.size());
        if (count == 0) {
            return text;
        }
        if (count < 0 && !passes(errno)) {
            return Error{ErrorCode::ReadFailed, said("standard input cannot be read: %1", std::strerror(errno)), {}, {}};
        }
        text.append(buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    }
    return Error{ErrorCode::TooLarge, said("standard input has more than the %1 bytes that are read", mostBytes), {}, {}};
}

Status print(std::string_view text)
{
    while (!text.empty()) {
        if (!waitFor(STDOUT_FILENO, POLLOUT)) {
            return interrupted();
        }
        // A pipe that can be written takes this much without making us wait for its reader.
        const ssize_t count = ::write(STDOUT_FILENO, text.data(), std::min<std::size_t>(text.size(), PIPE_BUF));
        if (count < 0 && !passes(errno)) {
            return Error{ErrorCode::WriteFailed, said("standard output cannot be written: %1", std::strerror(errno)), {}, {}};
        }
        text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    }
    return Done{};
}

Status print(std::span<const std::byte> bytes)
{
    return print(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

Status writeOutput(const std::string& path, std::string_view text)
{
    if (path == kStandardStream) {
        return print(text);
    }
    if (Status status = makeFolderOf(path); !status) {
        return status;
    }
    return writeFileAtomically(path, text);
}

} // namespace fumage::cli
