#include "core/export/output_name.h"

#include "core/system/path.h"
#include "core/base/text.h"

#include <algorithm>

namespace fumage {

namespace {

/// The last run of two or more of a letter.
std::optional<NumberPlace> lastRunOf(char letter, std::string_view name)
{
    for (std::size_t past = name.find_last_of(letter) + 1; past != 0;
         past = name.substr(0, past - 1).find_last_of(letter) + 1) {
        const std::size_t before = name.substr(0, past).find_last_not_of(letter) + 1; // 0 where there is none
        if (past - before > 1) {
            return NumberPlace{before, past - before, past - before};
        }
    }
    return std::nullopt;
}

/// The last of what printf calls "%04d", with one digit or more.
std::optional<NumberPlace> lastConversionIn(std::string_view name)
{
    constexpr std::size_t kLength = 4;
    for (std::size_t at = name.rfind("%0"); at != std::string_view::npos;
         at = at == 0 ? std::string_view::npos : name.rfind("%0", at - 1)) {
        const std::string_view rest = name.substr(at, kLength);
        if (rest.size() == kLength && rest[2] >= '1' && rest[2] <= '9' && rest[3] == 'd') {
            return NumberPlace{at, kLength, static_cast<std::size_t>(rest[2] - '0')};
        }
    }
    return std::nullopt;
}

std::string listOf(std::span<const std::string_view> endings)
{
    std::string list;
    for (const std::string_view ending : endings) {
        list += (list.empty() ? "" : ending == endings.back() ? " or " : ", ") + std::string(ending);
    }
    return list;
}

} // namespace

std::optional<NumberPlace> numberPlaceIn(std::string_view name)
{
    const std::optional<NumberPlace> run = lastRunOf('#', name);
    return run ? run : lastConversionIn(name);
}

std::string endingOf(const std::filesystem::path& path)
{
    const std::string ending = path.extension().string();
    const std::optional<NumberPlace> place = numberPlaceIn(ending);
    const bool isNumber =
        ending.find_first_not_of(".#") == std::string::npos || (place && place->length + 1 == ending.size());
    return isNumber ? std::string() : inSmallLetters(ending);
}

std::string nameWithoutNumber(const std::filesystem::path& output)
{
    std::string name = output.stem().string();
    if (const std::optional<NumberPlace> place = numberPlaceIn(name)) {
        name.erase(place->at, place->length);
    }
    name.erase(name.find_last_not_of("_-. ") + 1);
    return name.empty() ? "frames" : name;
}

Error nameNotUtf8(const std::filesystem::path& output)
{
    return {ErrorCode::NotUtf8, makeMessage("this name is not UTF-8, and has to be written down in a file beside it"),
        output.string(), makeMessage("Choose another name")};
}

Error wouldOverwrite(const std::filesystem::path& source)
{
    return {ErrorCode::WouldOverwrite, makeMessage("this would overwrite the preset that it is made of"),
        source.string(), makeMessage("Choose another name")};
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
        return Error{ErrorCode::NotAFile, makeMessage("cannot write: %1", makeMessage("it is not a regular file")),
            named, makeMessage("Name a file, or - for standard output")};
    }
    const std::string ending = endingOf(path);
    if (!ending.empty() && std::find(names.endings.begin(), names.endings.end(), ending) == names.endings.end()) {
        return Error{ErrorCode::UnknownName, makeMessage("the ending %1 does not fit", inQuotes(ending)), named,
            makeMessage("Use %1", listOf(names.endings))};
    }
    return path;
}

} // namespace fumage
