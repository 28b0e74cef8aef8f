#pragma once

#include "core/base/alignment.h"

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace fumage {

/// Memory for arrays, not initialised. From 4 MiB on it is the system's own and goes back to it when it is freed; and
/// it asks for large pages where there are any: kernels that jump about in an array then do not wait for its page
/// table.
/// @param bytes more than 0
/// @throws std::bad_alloc
[[nodiscard]] void* allocateAligned(std::size_t bytes);
/// @param bytes as it was allocated
void freeAligned(void* pointer, std::size_t bytes);

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
        if (count > static_cast<std::size_t>(-1) / sizeof(T)) {
            throw std::bad_array_new_length();
        }
        return static_cast<T*>(allocateAligned(count * sizeof(T)));
    }
    void deallocate(T* pointer, std::size_t count) { freeAligned(pointer, count * sizeof(T)); }
    friend bool operator==(const AlignedAllocator& /*a*/, const AlignedAllocator& /*b*/) { return true; }
};

template <class T>
using AlignedArray = std::vector<T, AlignedAllocator<T>>;

/// The same, but that elements are undefined until they are written: resize() leaves the memory alone, and the threads
/// that write it first share the time that the system takes to hand it out.
template <class T>
struct RawAllocator : AlignedAllocator<T> {
    static_assert(std::is_trivially_default_constructible_v<T>);
    RawAllocator() = default;
    template <class U>
    RawAllocator(const RawAllocator<U>& /*other*/) // NOLINT(google-explicit-constructor): allocators convert
    {
    }
    template <class U>
    void construct(U* place)
    {
        ::new (static_cast<void*>(place)) U;
    }
    template <class U, class First, class... Rest>
    void construct(U* place, First&& first, Rest&&... rest)
    {
        ::new (static_cast<void*>(place)) U(std::forward<First>(first), std::forward<Rest>(rest)...);
    }
};

template <class T>
using RawArray = std::vector<T, RawAllocator<T>>;

} // namespace fumage
