#include "core/export/output_name.h"

#include "core/base/path.h"
#include "core/base/text.h"

#include <algorithm>
#include <cstdint>

namespace fumage {

namespace {

/// Replaces printf's way to number files, as in "%04d", by a run of #.
std::string withHashes(const std::string& name)
{
    constexpr std::int64_t kMostDigits = 9;
    const std::size_t percent = name.find('%');
    const std::size_t letter = percent == std::string::npos ? percent : name.find_first_not_of("0123456789", percent + 1);
    if (letter == std::string::npos || name[letter] != 'd') {
        return name;
    }
    const std::int64_t width = parseInteger(std::string_view(name).substr(percent + 1, letter - percent - 1)).value_or(1);
    return name.substr(0, percent) + std::string(static_cast<std::size_t>(std::clamp<std::int64_t>(width, 1, kMostDigits)), '#') + name.substr(letter + 1);
}

std::string listOf(std::span<const std::string_view> endings)
{
    std::string list;
    for (const std::string_view ending : endings) {
        list += (list.empty() ? "" : ending == endings.back() ? " or "
                                                              : ", ")
            + std::string(ending);
    }
    return list;
}

} // namespace

std::string endingOf(const std::filesystem::path& path)
{
    const std::string ending = path.extension().string();
    return ending.find_first_not_of(".#") == std::string::npos ? std::string() : inSmallLetters(ending);
}

std::string nameWithoutNumber(const std::filesystem::path& output)
{
    std::string name = output.stem().string();
    name.erase(std::remove(name.begin(), name.end(), '#'), name.end());
    name.erase(name.find_last_not_of("_-. ") + 1);
    return name.empty() ? "frames" : name;
}

Error wouldOverwrite(const std::filesystem::path& source)
{
    return {ErrorCode::WouldOverwrite, said("this would overwrite the preset that it is made of"), source.string(), said("Choose another name")};
}

Result<std::filesystem::path> outputPath(const std::string& named, const OutputNames& names)
{
    std::filesystem::path path = pathFrom(named);
    std::error_code missing;
    const std::filesystem::file_status there = std::filesystem::status(path, missing);
    if (named.empty() || path.filename().empty() || std::filesystem::is_directory(there)) {
        return path / pathFrom(names.fallback + std::string(names.endings.front()));
    }
    if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there)) {
        return Error{ErrorCode::NotAFile, said("cannot write: %1", said("it is not a regular file")), named, said("Name a file, or - for standard output")};
    }
    path.replace_filename(pathFrom(withHashes(path.filename().string())));
    const std::string ending = endingOf(path);
    if (!ending.empty() && std::find(names.endings.begin(), names.endings.end(), ending) == names.endings.end()) {
        return Error{ErrorCode::UnknownName, said("the ending %1 does not fit", inQuotes(ending)), named, said("Use %1", listOf(names.endings))};
    }
    return path;
}

} // namespace fumage
