#pragma once

#include "core/base/result.h"
#include "core/export/sequence.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace fumage::cli {

/// The name that stands for standard input and standard output.
inline constexpr std::string_view kStandardStream = "-";

/// From now on warn() and report() say nothing.
void beQuiet();

/// From now on progress and failures are said on standard output too, as Open Job Description hears them:
/// "openjd_progress: 50".
void talkToOpenJd();
[[nodiscard]] bool talksToOpenJd();
/// Says a line of Open Job Description, where somebody hears it.
/// @param what "progress", "status" or "fail"
void tellOpenJd(std::string_view what, const std::string& text);

/// Prints "fumage-cli: warning: ..." to standard error.
void warn(const std::string& text);

/// Says what was done, on standard error.
void report(const std::string& text);

/// Says which files were written.
void tellWritten(int count, const std::filesystem::path& first, const std::filesystem::path& last);
/// The same of numbered files; see framePath().
void tellWritten(const std::filesystem::path& output, const FrameRange& frames, std::string_view ending);

/// Reads all of standard input; ends early when the user interrupts, even where nobody writes.
/// @error TooLarge, ReadFailed, Cancelled
[[nodiscard]] Result<std::string> readStandardInput(std::size_t mostBytes);

/// Writes to standard output; ends early when the user interrupts, even where nobody reads. Text may be left by its
/// reader in the middle, as `head` does: that is no failure. Bytes may not.
/// @error WriteFailed, Cancelled
[[nodiscard]] Status print(std::string_view text);
[[nodiscard]] Status print(std::span<const std::byte> bytes);

/// Writes to a file, or to standard output for "-".
[[nodiscard]] Status writeOutput(const std::string& path, std::string_view text);

} // namespace fumage::cli
