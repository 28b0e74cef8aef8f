#include "core/base/aligned_array.h"

#include "core/base/large_memory.h"

namespace fumage {

namespace {

constexpr bool isLarge(std::size_t bytes)
{
    return bytes >= 2 * kLargePage;
}

} // namespace

void* allocateAligned(std::size_t bytes)
{
    return isLarge(bytes) ? mapLarge(bytes) : ::operator new (bytes, std::align_val_t{kAlignment});
}

void freeAligned(void* pointer, std::size_t bytes)
{
    if (isLarge(bytes)) {
        unmapLarge(pointer, bytes);
    } else {
        ::operator delete (pointer, std::align_val_t{kAlignment});
    }
}

} // namespace fumage
