#pragma once

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

// Every new of the program goes through here, so that a test can tell whether something allocates. Included by one
// source of a program.

namespace fumage::tests {

inline std::atomic<std::size_t> allocationCount{0};

/// How often the program has allocated.
inline std::size_t allocations()
{
    return allocationCount.load();
}

inline void* counted(void* memory)
{
    ++allocationCount;
    if (memory == nullptr) {
        throw std::bad_alloc();
    }
    return memory;
}

} // namespace fumage::tests

void* operator new(std::size_t size)
{
    return fumage::tests::counted(std::malloc(size == 0 ? 1 : size));
}

void* operator new(std::size_t size, std::align_val_t alignment)
{
    const auto step = static_cast<std::size_t>(alignment);
    return fumage::tests::counted(std::aligned_alloc(step, (size + step - 1) / step * step));
}

void* operator new(std::size_t size, const std::nothrow_t& /*nothrow*/) noexcept
{
    ++fumage::tests::allocationCount;
    return std::malloc(size == 0 ? 1 : size);
}

void operator delete(void* memory) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t /*size*/) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept
{
    std::free(memory);
}
