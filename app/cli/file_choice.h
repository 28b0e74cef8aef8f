#pragma once

#include "core/export/image_file.h"
#include "core/export/output_name.h"

#include <algorithm>
#include <array>
#include <string>

namespace fumage::cli {

/// A file to write, and its format.
template <class Format>
struct FileChoice {
    std::filesystem::path file;
    Format format;
};

/// @param name its ending without the dot; any other: the first of them
template <class Format, std::size_t kCount>
Format formatNamed(const std::array<Format, kCount>& formats, std::string_view name)
{
    const auto* const found = std::find_if(
        formats.begin(), formats.end(), [&](Format format) { return fileEnding(format).substr(1) == name; });
    return found == formats.end() ? formats.front() : *found;
}

/// By the name of a format, or else by the ending of the file.
/// @param output,presetName see outputPath() @param formatName empty: not named
/// @error that of outputPath()
template <class Format, std::size_t kCount>
Result<FileChoice<Format>> chooseFile(const std::string& output, const std::string& formatName,
    const std::string& presetName, const std::array<Format, kCount>& formats)
{
    std::array<std::string_view, kCount> endings;
    std::transform(formats.begin(), formats.end(), endings.begin(), [](Format format) { return fileEnding(format); });
    const std::string_view wanted = fileEnding(formatNamed(formats, formatName));
    const Result<std::filesystem::path> path = outputPath(
        output, {formatName.empty() ? std::span<const std::string_view>(endings) : std::span(&wanted, 1), presetName});
    if (!path) {
        return path.error();
    }
    const std::string ending = endingOf(path.value());
    const Format format = formatNamed(formats, (ending.empty() ? wanted : std::string_view(ending)).substr(1));
    return FileChoice<Format>{withEnding(path.value(), fileEnding(format)), format};
}

} // namespace fumage::cli
