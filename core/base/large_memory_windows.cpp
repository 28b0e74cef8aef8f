#include "core/base/large_memory.h"

#include "core/base/windows_api.h"

#include <new>

namespace fumage {

namespace {

constexpr std::size_t kStep = std::size_t{1} << 16U; ///< on multiples of which Windows gives memory

} // namespace

/// In pages of the usual size: larger ones need a privilege that users do not have.
void* mapLarge(std::size_t bytes)
{
    if (bytes > static_cast<std::size_t>(-1) - kStep) {
        throw std::bad_alloc();
    }
    void* const room = ::VirtualAlloc(nullptr, bytes + kMaxShifted, MEM_RESERVE | MEM_COMMIT, PAGE_READWRITE);
    if (room == nullptr) {
        throw std::bad_alloc();
    }
    return static_cast<std::byte*>(room) + shiftAt(room, kStep);
}

void unmapLarge(void* pointer, std::size_t /*bytes*/)
{
    const std::size_t shift = reinterpret_cast<std::uintptr_t>(pointer) % kStep;
    ::VirtualFree(static_cast<std::byte*>(pointer) - shift, 0, MEM_RELEASE);
}

} // namespace fumage
