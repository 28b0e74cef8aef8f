#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace fumage {

/// What a name that a person gives for an output may be.
struct OutputNames {
    std::span<const std::string_view> endings; ///< with their dots, small letters
    std::string fallback; ///< name without ending, where only a folder is named
};

/// Where the number of a frame stands in the name of a file.
struct NumberPlace {
    std::size_t at = 0;
    std::size_t length = 0;
    std::size_t digits = 0; ///< zeros fill them
};

/// The last run of two or more #; where there is none, the last "%04d" or its like, as other programs have it. All
/// other # and % are letters.
[[nodiscard]] std::optional<NumberPlace> numberPlaceIn(std::string_view name);

/// The ending of a path in small letters, with its dot; empty where it has none. What stands for a number, and a dot at
/// the beginning of the name is no ending.
[[nodiscard]] std::string endingOf(const std::filesystem::path& path);

/// The name of numbered files without folder, number and ending: "smoke" of "out/smoke_####.exr"; "frames" where
/// nothing is left.
[[nodiscard]] std::string nameWithoutNumber(const std::filesystem::path& output);

/// Makes the path of an output of what a person has named: a folder, or what ends with a slash, gets a file with the
/// fallback's name. An ending may be left out.
/// @error UnknownName where the ending is another; NotAFile where there is something that is neither file nor folder
[[nodiscard]] Result<std::filesystem::path> outputPath(const std::string& named, const OutputNames& names);

/// What is said where a name would stand in a file for others to read, and cannot.
[[nodiscard]] Error nameNotUtf8(const std::filesystem::path& output);

/// What is said where an export names the file of the preset that it is made of.
[[nodiscard]] Error wouldOverwrite(const std::filesystem::path& source);

} // namespace fumage
