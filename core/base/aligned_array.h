#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace fumage {

/// One cache line, and the widest vector register that the kernels use.
inline constexpr std::size_t kAlignment = 64;

/// Allocator that aligns to kAlignment, so that kernels may use aligned loads at index 0.
template <class T>
struct AlignedAllocator {
    using value_type = T;
    AlignedAllocator() = default;
    template <class U>
    AlignedAllocator(const AlignedAllocator<U>& /*other*/) // NOLINT(google-explicit-constructor): allocators convert
    {
    }
    T* allocate(std::size_t count)
    {
        return static_cast<T*>(::operator new (count * sizeof(T), std::align_val_t{kAlignment}));
    }
    void deallocate(T* pointer, std::size_t /*count*/) { ::operator delete (pointer, std::align_val_t{kAlignment}); }
    friend bool operator==(const AlignedAllocator& /*a*/, const AlignedAllocator& /*b*/) { return true; }
};

template <class T>
using AlignedArray = std::vector<T, AlignedAllocator<T>>;

/// @return count rounded up to a whole number of multiples
[[nodiscard]] constexpr std::size_t roundUp(std::size_t count, std::size_t multiple)
{
    return (count + multiple - 1) / multiple * multiple;
}

} // namespace fumage
