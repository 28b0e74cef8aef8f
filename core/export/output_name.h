#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace fumage {

/// What a name that a person gives for an output may be.
struct OutputNames {
    std::span<const std::string_view> endings; ///< with their dots, small letters
    std::string fallback; ///< name without ending, where only a folder is named
};

/// The ending of a path in small letters, with its dot; empty where it has none. A run of # or a dot at the beginning of the name is no ending.
[[nodiscard]] std::string endingOf(const std::filesystem::path& path);

/// The name of numbered files without folder, number and ending: "smoke" of "out/smoke_####.exr"; "frames" where nothing is left.
[[nodiscard]] std::string nameWithoutNumber(const std::filesystem::path& output);

/// Makes the path of an output of what a person has named: "%04d" becomes "####"; a folder, or what ends with a slash, gets a file with the fallback's
/// name. An ending may be left out.
/// @error UnknownName where the ending is another; NotAFile where there is something that is neither file nor folder
[[nodiscard]] Result<std::filesystem::path> outputPath(const std::string& named, const OutputNames& names);

/// What is said where an export names the file of the preset that it is made of.
[[nodiscard]] Error wouldOverwrite(const std::filesystem::path& source);

} // namespace fumage
