#include "core/rendering/depth_sort.h"

#include <algorithm>
#include <array>

namespace fumage {

namespace {

constexpr unsigned kDigitBits = 11;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
using Histogram = std::array<std::uint32_t, kDigits>;

constexpr std::size_t digit(DepthEntry entry, unsigned pass)
{
    return static_cast<std::size_t>(entry >> (32U + pass * kDigitBits)) & (kDigits - 1);
}

void toOffsets(Histogram& histogram)
{
    std::uint32_t sum = 0;
    for (std::uint32_t& count : histogram) {
        const std::uint32_t here = count;
        count = sum;
        sum += here;
    }
}

void scatter(std::span<const DepthEntry> from, DepthEntry* to, Histogram& offsets, unsigned pass)
{
    for (const DepthEntry entry : from) {
        to[offsets[digit(entry, pass)]++] = entry;
    }
}

} // namespace

void sortByDepth(std::span<DepthEntry> entries, AlignedArray<DepthEntry>& scratch)
{
    // Below this the histograms cost more than comparing.
    constexpr std::size_t kFew = 96;
    if (entries.size() < kFew) {
        std::sort(entries.begin(), entries.end());
        return;
    }
    if (scratch.size() < entries.size()) {
        scratch.resize(entries.size());
    }
    Histogram low{};
    Histogram high{};
    for (const DepthEntry entry : entries) {
        ++low[digit(entry, 0)];
        ++high[digit(entry, 1)];
    }
    toOffsets(low);
    toOffsets(high);
    scatter(entries, scratch.data(), low, 0);
    scatter({scratch.data(), entries.size()}, entries.data(), high, 1);
}

} // namespace fumage
