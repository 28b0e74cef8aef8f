#pragma once

#include <cstddef>

namespace fumage {

/// One cache line, and the widest vector register that the kernels use.
inline constexpr std::size_t kAlignment = 64;

/// @return count rounded up to a whole number of multiples
[[nodiscard]] constexpr std::size_t roundUp(std::size_t count, std::size_t multiple)
{
    return (count + multiple - 1) / multiple * multiple;
}

} // namespace fumage
