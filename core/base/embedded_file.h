#pragma once

#include <algorithm>
#include <span>
#include <string_view>

namespace fumage {

/// A file that was compiled into the library.
struct EmbeddedFile {
    std::string_view name; ///< without folder and ending
    std::string_view contents;
};

/// @return null where none has this name
[[nodiscard]] inline const EmbeddedFile* findEmbedded(std::span<const EmbeddedFile> files, std::string_view name)
{
    const auto found = std::ranges::find(files, name, &EmbeddedFile::name);
    return found == files.end() ? nullptr : &*found;
}

} // namespace fumage
