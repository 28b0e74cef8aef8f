#include "core/base/heap.h"

#include <cstdlib> // says which C library this is

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace fumage {

void keepHeapSmall()
{
#ifdef __GLIBC__
    constexpr int kPools = 2; // of 64 MB each and more; a program of 25 threads would make 8 for each core
    constexpr int kLarge = 1 << 20; // bytes
    mallopt(M_ARENA_MAX, kPools);
    mallopt(M_MMAP_THRESHOLD, kLarge); // said, it stays: else it grows with what is freed, to 32 MB
    mallopt(M_TRIM_THRESHOLD, kLarge);
#endif
}

void giveBackMemory()
{
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

} // namespace fumage
