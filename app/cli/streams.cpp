#include "app/cli/streams.h"

#include "app/cli/system.h"

#include "core/system/file.h"
#include "core/system/path.h"
#include "core/base/text.h"

#include <array>
#include <atomic>
#include <iostream>

namespace fumage::cli {

namespace {

std::atomic<bool> hearsOpenJd = false; // set before any work begins

Error interrupted()
{
    return {ErrorCode::Cancelled, makeMessage("interrupted"), {}, {}};
}

/// Whoever reads standard output.
enum class Reader {
    Stays, ///< to the end; it is a failure where it does not
    MayLeave, ///< as `head` does, which has had enough of a list
};

Status writeAll(std::string_view text, Reader reader)
{
    while (!text.empty()) {
        const Transferred part = writeSome(text);
        if (part.isInterrupted) {
            return interrupted();
        }
        if (part.isUnread && reader == Reader::MayLeave) {
            return Done{};
        }
        if (!part.failure.empty()) {
            return Error{
                ErrorCode::WriteFailed, makeMessage("standard output cannot be written: %1", part.failure), {}, {}};
        }
        text.remove_prefix(part.count);
    }
    return Done{};
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

void report(const std::string& text)
{
    std::clog << "fumage-cli: " << printable(text) << std::endl;
}

void tellWritten(int count, const std::filesystem::path& first, const std::filesystem::path& last)
{
    report(count == 1 ? "wrote " + first.string()
                      : "wrote " + std::to_string(count) + " files, " + first.string() + " to " + last.string());
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
        const Transferred part = readSome(buffer);
        if (part.isInterrupted) {
            return interrupted();
        }
        if (!part.failure.empty()) {
            return Error{ErrorCode::ReadFailed, makeMessage("standard input cannot be read: %1", part.failure), {}, {}};
        }
        if (part.count == 0) {
            return text;
        }
        text.append(buffer.data(), part.count);
    }
    return Error{
        ErrorCode::TooLarge, makeMessage("standard input has more than the %1 bytes that are read", mostBytes), {}, {}};
}

Status print(std::string_view text)
{
    return writeAll(text, Reader::MayLeave);
}

Status print(std::span<const std::byte> bytes)
{
    return writeAll(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()), Reader::Stays);
}

Status writeOutput(const std::string& path, std::string_view text)
{
    if (path == kStandardStream) {
        return print(text);
    }
    const std::filesystem::path file = pathFrom(path);
    if (Status status = makeFolderOf(file); !status) {
        return status;
    }
    return writeFileAtomically(file, text);
}

} // namespace fumage::cli
