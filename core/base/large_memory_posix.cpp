#include "core/base/large_memory.h"

#include <new>

#include <sys/mman.h>
#include <unistd.h>

namespace fumage {

namespace {

/// Whole pages, with room for the array wherever it begins.
std::size_t mappedSize(std::size_t bytes)
{
    return roundUp(bytes + kMaxShifted, static_cast<std::size_t>(sysconf(_SC_PAGESIZE)));
}

} // namespace

/// From the beginning of a large page on.
void* mapLarge(std::size_t bytes)
{
    if (bytes > static_cast<std::size_t>(-1) - 3 * kLargePage) {
        throw std::bad_alloc();
    }
    const std::size_t size = mappedSize(bytes);
    void* const room = mmap(nullptr, size + kLargePage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (room == MAP_FAILED) {
        throw std::bad_alloc();
    }
    auto* const begin = static_cast<std::byte*>(room);
    const std::size_t before = (kLargePage - reinterpret_cast<std::uintptr_t>(room) % kLargePage) % kLargePage;
    if (before > 0) {
        (void)munmap(begin, before);
    }
    if (before < kLargePage) {
        (void)munmap(begin + before + size, kLargePage - before);
    }
#ifdef MADV_HUGEPAGE
    // A wish: without large pages everything works as before.
    (void)madvise(begin + before, bytes / kLargePage * kLargePage, MADV_HUGEPAGE);
#endif
    return begin + before + shiftAt(begin + before, kLargePage);
}

void unmapLarge(void* pointer, std::size_t bytes)
{
    const std::size_t shift = reinterpret_cast<std::uintptr_t>(pointer) % kLargePage;
    (void)munmap(static_cast<std::byte*>(pointer) - shift, mappedSize(bytes));
}

} // namespace fumage
