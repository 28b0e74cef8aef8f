#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fumage {

/// Bytes as letters that any text can hold, with '=' at the end where they are not a multiple of three.
/// Source: RFC 4648, section 4. O(bytes).
[[nodiscard]] std::string base64Of(std::span<const std::byte> bytes);

/// How many letters so many bytes have.
[[nodiscard]] constexpr std::size_t base64Length(std::size_t bytes)
{
    return (bytes + 2) / 3 * 4;
}

/// @return the bytes of base64Of(); nothing where a text is not just what that writes: no spaces, no missing '=', no
/// bits behind the end. O(text).
[[nodiscard]] std::optional<std::vector<std::byte>> bytesOfBase64(std::string_view text);

} // namespace fumage
