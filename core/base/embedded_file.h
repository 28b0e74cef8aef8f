#pragma once

#include <string_view>

namespace fumage {

/// A file that was compiled into the library.
struct EmbeddedFile {
    std::string_view name; ///< without folder and ending
    std::string_view contents;
};

} // namespace fumage
