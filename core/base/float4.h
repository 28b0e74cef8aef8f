#pragma once

#include <cstring>

namespace fumage {

/// Four floats in one register, on every instruction set: light channels or a colour.
using Float4 = float __attribute__((vector_size(16)));

/// Reads a number or several at once, wherever they lie.
/// @tparam Value float or Float4
template <class Value>
[[nodiscard]] inline Value loadFloats(const float* from)
{
    Value out;
    std::memcpy(&out, from, sizeof(out));
    return out;
}

} // namespace fumage
