#pragma once

#include <filesystem>
#include <string_view>

namespace fumage {

/// The path that a text names. Texts are UTF-8 in all of the core; what std::filesystem::path itself takes a text of
/// char for is left to the system and its library, and may be ASCII alone. Wherever a text that is not a literal
/// becomes a path or a part of one, it goes through here.
/// @return on Windows with U+FFFD for what is not UTF-8; elsewhere with the bytes as they are
[[nodiscard]] std::filesystem::path pathFrom(std::string_view utf8);

} // namespace fumage
