#include "core/base/aligned_array.h"

#ifdef __linux__
#include <cstdint>
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace fumage {

#ifdef __linux__

namespace {

constexpr std::size_t kLargePage = std::size_t{1} << 21U;

constexpr bool isLarge(std::size_t bytes)
{
    return bytes >= 2 * kLargePage;
}

/// How far into its first page a mapped array begins: one of so many multiples.
constexpr std::size_t kShift = 5 * kAlignment;
constexpr std::size_t kShifts = 13;

/// Whole pages, with room for the array wherever it begins.
std::size_t mappedSize(std::size_t bytes)
{
    return roundUp(bytes + kShift * (kShifts - 1), static_cast<std::size_t>(sysconf(_SC_PAGESIZE)));
}

/// Memory of its own from the system, from the beginning of a large page on, and no more than is asked for: in the heap, arrays of several sizes that
/// come and go leave holes as large as themselves.
///
/// Arrays begin at different distances from a large page: kernels that go through several with all of them at the same one take up to 2.5 times as long.
void* mapAligned(std::size_t bytes)
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
    // A wish: without large pages everything works as before.
    (void)madvise(begin + before, bytes / kLargePage * kLargePage, MADV_HUGEPAGE);
    const std::size_t page = reinterpret_cast<std::uintptr_t>(begin + before) / kLargePage;
    return begin + before + page % kShifts * kShift;
}

void unmapAligned(void* pointer, std::size_t bytes)
{
    const std::size_t shift = reinterpret_cast<std::uintptr_t>(pointer) % kLargePage;
    (void)munmap(static_cast<std::byte*>(pointer) - shift, mappedSize(bytes));
}

} // namespace

void* allocateAligned(std::size_t bytes)
{
    return isLarge(bytes) ? mapAligned(bytes) : ::operator new (bytes, std::align_val_t{kAlignment});
}

void freeAligned(void* pointer, std::size_t bytes)
{
    if (isLarge(bytes)) {
        unmapAligned(pointer, bytes);
    } else {
        ::operator delete (pointer, std::align_val_t{kAlignment});
    }
}

#else

void* allocateAligned(std::size_t bytes)
{
    return ::operator new (bytes, std::align_val_t{kAlignment});
}

void freeAligned(void* pointer, std::size_t /*bytes*/)
{
    ::operator delete (pointer, std::align_val_t{kAlignment});
}

#endif

} // namespace fumage
