#include "core/base/aligned_array.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace fumage {

namespace {

constexpr std::size_t kLargePage = std::size_t{1} << 21U;

constexpr std::align_val_t alignmentOf(std::size_t bytes)
{
    return std::align_val_t{bytes >= 2 * kLargePage ? kLargePage : kAlignment};
}

} // namespace

void* allocateAligned(std::size_t bytes)
{
    void* pointer = ::operator new(bytes, alignmentOf(bytes));
#ifdef __linux__
    if (alignmentOf(bytes) == std::align_val_t{kLargePage}) {
        // A wish: without large pages everything works as before.
        (void)madvise(pointer, bytes / kLargePage * kLargePage, MADV_HUGEPAGE);
    }
#endif
    return pointer;
}

void freeAligned(void* pointer, std::size_t bytes)
{
    ::operator delete(pointer, alignmentOf(bytes));
}

} // namespace fumage
