#include "core/base/base64.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace fumage {

namespace {

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kNoDigit = 64;

constexpr std::array<std::uint8_t, 256> makeValues()
{
    std::array<std::uint8_t, 256> values{};
    values.fill(kNoDigit);
    for (std::size_t i = 0; i < kDigits.size(); ++i) {
        values[static_cast<unsigned char>(kDigits[i])] = static_cast<std::uint8_t>(i);
    }
    return values;
}

constexpr std::array<std::uint8_t, 256> kValues = makeValues();

} // namespace

std::string base64Of(std::span<const std::byte> bytes)
{
    std::string out;
    out.reserve(base64Length(bytes.size()));
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t three = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            three = three << 8U | (j < count ? std::to_integer<std::uint32_t>(bytes[i + j]) : 0U);
        }
        for (std::size_t j = 0; j < 4; ++j) {
            out += j <= count ? kDigits[three >> (18U - 6U * j) & 63U] : '=';
        }
    }
    return out;
}

std::optional<std::vector<std::byte>> bytesOfBase64(std::string_view text)
{
    if (text.size() % 4 != 0) {
        return std::nullopt;
    }
    std::vector<std::byte> out;
    out.reserve(text.size() / 4 * 3);
    for (std::size_t i = 0; i < text.size(); i += 4) {
        const bool isLast = i + 4 == text.size();
        const std::size_t padding = !isLast || text[i + 3] != '=' ? 0 : text[i + 2] != '=' ? 1 : 2;
        std::uint32_t three = 0;
        for (std::size_t j = 0; j < 4; ++j) {
            const std::uint8_t value = j < 4 - padding ? kValues[static_cast<unsigned char>(text[i + j])] : 0;
            if (value == kNoDigit) {
                return std::nullopt;
            }
            three = three << 6U | value;
        }
        if ((three & ((1U << 8U * padding) - 1U)) != 0) {
            return std::nullopt;
        }
        for (std::size_t j = 0; j < 3 - padding; ++j) {
            out.push_back(static_cast<std::byte>(three >> (16U - 8U * j) & 255U));
        }
    }
    return out;
}

} // namespace fumage
