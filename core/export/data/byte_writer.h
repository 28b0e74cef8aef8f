#pragma once

#include <bit>
#include <cstdint>
#include <string>

namespace fumage {

/// Appends the low bytes of a number, the lowest first.
inline void appendLittleEndian(std::string& out, std::uint32_t bits, unsigned bytes = 4)
{
    for (unsigned i = 0; i < bytes; ++i) {
        out += static_cast<char>(bits >> 8U * i & 255U);
    }
}

/// Appends a float as IEEE 754 has it, the lowest byte first.
inline void appendLittleEndian(std::string& out, float value)
{
    appendLittleEndian(out, std::bit_cast<std::uint32_t>(value));
}

} // namespace fumage
