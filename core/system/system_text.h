#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fumage {

/// Texts of Windows as UTF-8, in which all of the core's texts are. What is no Unicode becomes U+FFFD.
[[nodiscard]] std::string utf8From(std::wstring_view text);
[[nodiscard]] std::wstring wideFrom(std::string_view utf8);

/// What Windows says of one of its errors, in the user's language.
[[nodiscard]] std::string systemText(unsigned long error);

} // namespace fumage
