#pragma once

#include "core/base/aligned_array.h"

#include <cstdint>
#include <span>

namespace fumage {

/// A sprite in a list to sort: depth key in the upper half, index in the lower.
using DepthEntry = std::uint64_t;

/// @param key of depth, greater is farther
[[nodiscard]] constexpr DepthEntry depthEntry(std::uint32_t key, std::uint32_t index)
{
    return static_cast<DepthEntry>(key) << 32U | index;
}

/// The index that depthEntry() was given.
[[nodiscard]] constexpr std::uint32_t entryIndex(DepthEntry entry)
{
    return static_cast<std::uint32_t>(entry);
}

/// Sorts near to far by the key, of which SpriteBatch::kDepthBits bits are used, and equal depths by their indices.
/// Radix sort in two passes of 11 bits. O(entries).
/// @param entries by rising indices
/// @param scratch grows to the number of entries; reused between calls
void sortByDepth(std::span<DepthEntry> entries, AlignedArray<DepthEntry>& scratch);

} // namespace fumage
