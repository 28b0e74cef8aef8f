#pragma once

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

/// Makes the folder that a file is to lie in, and those above it.
/// @error PermissionDenied
[[nodiscard]] Status makeFolderOf(const std::filesystem::path& file);

/// Writes a file so that it is either there as a whole or not at all: into a temporary file beside it, flushed to the disk, then renamed.
/// What was there before stays until then, and for good if anything fails.
/// @error PermissionDenied, FileNotFound (no such folder), NotAFile, DiskFull, WriteFailed; the place is the path
[[nodiscard]] Status writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes);
[[nodiscard]] Status writeFileAtomically(const std::filesystem::path& path, std::string_view text);

} // namespace fumage
