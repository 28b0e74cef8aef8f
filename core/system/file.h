#pragma once

#include "core/system/file_access.h"
#include "core/base/result.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace fumage {

/// Reads a whole regular file.
/// @param mostBytes a larger file is refused before anything is allocated
/// @error FileNotFound, NotAFile, PermissionDenied, TooLarge, ReadFailed; the place is the path
[[nodiscard]] Result<std::string> readFile(const std::filesystem::path& path, std::size_t mostBytes);

/// Reads the beginning of a regular file of any size.
/// @param mostBytes of it; a shorter file is read whole
/// @error as readFile(), but never TooLarge
[[nodiscard]] Result<std::string> readFileHead(const std::filesystem::path& path, std::size_t mostBytes);

/// Makes the folder that a file is to lie in, and those above it; clears away what writers that were killed have left
/// in it.
/// @error those of writeFileAtomically()
[[nodiscard]] Status makeFolderOf(const std::filesystem::path& file);

/// Removes the temporary files of writers that were killed. Those of running programs stay. O(files in the folder).
void clearLeftovers(const std::filesystem::path& folder);

/// Writes a file so that it is either there as a whole or not at all: into a temporary one, flushed to the disk, which
/// then takes its place. The temporary file has no name where the file system can do that, so that nothing is left
/// behind by a program that is killed. What was there before stays until then, and for good if anything fails. Its mode
/// is kept, its owner and group where that is allowed. Other hard links to it keep the old contents. A symbolic link
/// stays, and its target is written.
/// @error PermissionDenied, FileNotFound (no such folder), NotAFile, DiskFull, WriteFailed; the place is the path, or
/// the folder if that is to blame
[[nodiscard]] Status writeFileAtomically(
    const std::filesystem::path& path, std::span<const std::byte> bytes, FileAccess access = FileAccess::Usual);
[[nodiscard]] Status writeFileAtomically(
    const std::filesystem::path& path, std::string_view text, FileAccess access = FileAccess::Usual);

struct FileContents {
    std::filesystem::path path;
    std::span<const std::byte> bytes;
};

/// Writes files of one folder that belong together. Of two programs that write the same files at once one wins with all
/// of them.
/// @param files one or more
/// @error as writeFileAtomically(); nothing has changed then, unless the disk failed between taking the first place and
/// the last
[[nodiscard]] Status writeTogetherAtomically(std::span<const FileContents> files);

/// Whether two paths lead to one file that is there.
[[nodiscard]] bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

} // namespace fumage
