#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace fumage {

/// A hash that nobody can find a second text for, taken of bytes that come piece by piece. The same as what the program
/// sha256sum prints. Source: FIPS 180-4, "Secure Hash Standard", 2015. O(bytes), some 300 MB/s.
class Sha256 {
public:
    /// Takes more bytes in.
    void add(std::span<const std::byte> bytes);
    void add(std::string_view text);

    /// @return 64 small hexadecimal digits; nothing may be added afterwards
    [[nodiscard]] std::string finish();

private:
    static constexpr std::size_t kBlock = 64;

    void takeBlock(const std::byte* block);

    std::array<std::uint32_t, 8> m_state{
        0x6a09e667U, 0xbb67ae85U, 0x3c6ef372U, 0xa54ff53aU, 0x510e527fU, 0x9b05688cU, 0x1f83d9abU, 0x5be0cd19U};
    std::array<std::byte, kBlock> m_waiting{};
    std::size_t m_count = 0; ///< bytes so far
};

/// That of a whole text.
[[nodiscard]] std::string sha256Of(std::span<const std::byte> bytes);
[[nodiscard]] std::string sha256Of(std::string_view text);

/// Whether a text is 64 small hexadecimal digits.
[[nodiscard]] bool isSha256(std::string_view text);

} // namespace fumage
