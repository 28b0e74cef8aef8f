#pragma once

#include "core/base/alignment.h"

#include <cstddef>
#include <cstdint>

namespace fumage {

inline constexpr std::size_t kLargePage = std::size_t{1} << 21U;

/// How far into its first page an array of the system's own memory begins: one of so many multiples. Kernels that go
/// through several arrays with all of them at the same distance from a page take up to 2.5 times as long.
inline constexpr std::size_t kShift = 5 * kAlignment;
inline constexpr std::size_t kShifts = 13;
inline constexpr std::size_t kMaxShifted = kShift * (kShifts - 1);

/// @param size of the steps in which the system gives memory
[[nodiscard]] inline std::size_t shiftAt(const void* memory, std::size_t size)
{
    return reinterpret_cast<std::uintptr_t>(memory) / size % kShifts * kShift;
}

/// Memory of its own from the system, and no more than is asked for: in the heap, arrays of several sizes that come and
/// go leave holes as large as themselves.
/// @throws std::bad_alloc
[[nodiscard]] void* mapLarge(std::size_t bytes);
/// @param bytes as it was mapped
void unmapLarge(void* pointer, std::size_t bytes);

} // namespace fumage
