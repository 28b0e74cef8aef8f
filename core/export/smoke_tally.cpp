#include "core/export/smoke_tally.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <optional>

namespace fumage {

namespace {

/// Sums of weights over rectangles, from those that begin at the top left.
/// Source: Crow, "Summed-area tables for texture mapping", SIGGRAPH 1984.
class SummedArea {
public:
    SummedArea(const std::vector<std::uint64_t>& weights, int width, int height)
        : m_width(width)
        , m_height(height)
        , m_sums(static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(height + 1))
    {
        std::size_t pixel = 0;
        for (int y = 0; y < height; ++y) {
            std::uint64_t row = 0;
            for (int x = 0; x < width; ++x) {
                row += weights[pixel++];
                m_sums[index(x + 1, y + 1)] = m_sums[index(x + 1, y)] + row;
            }
        }
    }

    [[nodiscard]] std::uint64_t of(const PictureReach& reach) const
    {
        return m_sums[index(reach.right, reach.bottom)] + m_sums[index(reach.left, reach.top)]
            - m_sums[index(reach.left, reach.bottom)] - m_sums[index(reach.right, reach.top)];
    }
    [[nodiscard]] int width() const { return m_width; }
    [[nodiscard]] int height() const { return m_height; }

private:
    [[nodiscard]] std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width + 1) + static_cast<std::size_t>(x);
    }

    int m_width;
    int m_height;
    std::vector<std::uint64_t> m_sums;
};

enum class Side {
    Left,
    Right,
    Top,
    Bottom,
};
constexpr std::array kSides{Side::Left, Side::Right, Side::Top, Side::Bottom};

/// Lines along a side of a rectangle, and what is left without them.
struct Strip {
    PictureReach left;
    double gain; ///< share of the picture's width or height
    std::uint64_t weight;

    [[nodiscard]] bool isBetterThan(const Strip& other) const
    {
        const double here = gain * static_cast<double>(other.weight);
        const double there = other.gain * static_cast<double>(weight);
        return here > there || (weight == 0 && other.weight == 0 && gain > other.gain);
    }
};

Strip stripOf(const SummedArea& sums, const PictureReach& reach, Side side, int lines)
{
    PictureReach strip = reach;
    PictureReach left = reach;
    switch (side) {
    case Side::Left: left.left = strip.right = reach.left + lines; break;
    case Side::Right: left.right = strip.left = reach.right - lines; break;
    case Side::Top: left.top = strip.bottom = reach.top + lines; break;
    case Side::Bottom: left.bottom = strip.top = reach.bottom - lines; break;
    }
    const int edge = side == Side::Left || side == Side::Right ? sums.width() : sums.height();
    return {left, static_cast<double>(lines) / static_cast<double>(edge), sums.of(strip)};
}

/// @param most weight of a strip
std::optional<Strip> bestStrip(const SummedArea& sums, const PictureReach& reach, std::uint64_t most)
{
    std::optional<Strip> best;
    for (const Side side : kSides) {
        const bool isAcross = side == Side::Left || side == Side::Right;
        const int lines = isAcross ? reach.right - reach.left : reach.bottom - reach.top;
        for (int count = 1; count < lines; ++count) {
            const Strip strip = stripOf(sums, reach, side, count);
            if (strip.weight > most) {
                break; // more lines weigh no less
            }
            if (!best || strip.isBetterThan(*best)) {
                best = strip;
            }
        }
    }
    return best;
}

std::uint64_t shareOf(std::uint64_t total, double share)
{
    return static_cast<std::uint64_t>(static_cast<double>(total) * share);
}

/// Depths of a bin have the bits of a float but for these in common: positive floats sort as their bits do.
constexpr unsigned kDepthBits = 17; // 64 bins from a power of two to the next
constexpr std::size_t kDepthBins = std::size_t{1} << (31U - kDepthBits);

} // namespace

SmokeTally::SmokeTally(int width, int height, float alpha)
    : m_width(width)
    , m_height(height)
    , m_alpha(alpha)
    , m_weights(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
{
}

void SmokeTally::add(const Image& image)
{
    assert(image.width == m_width && image.height == m_height);
    constexpr float kSteps = 65535.0F;
    std::vector<Run> runs;
    auto weight = m_weights.begin();
    for (int y = 0; y < m_height; ++y) {
        bool wasSeen = false;
        for (int x = 0; x < m_width; ++x, ++weight) {
            const glm::vec4 pixel = image.at(x, y);
            const bool isSeen = pixel.a >= m_alpha;
            if (isSeen) {
                const float seen = std::min(std::max({pixel.a, pixel.r, pixel.g, pixel.b}), 1.0F);
                *weight += static_cast<std::uint64_t>(seen * kSteps + 0.5F);
                if (!wasSeen) {
                    runs.push_back({y, x, x});
                }
                runs.back().end = x + 1;
            }
            wasSeen = isSeen;
        }
    }
    runs.shrink_to_fit();
    m_runs.push_back(std::move(runs));
}

PictureReach SmokeTally::reachIn(std::size_t index, const PictureReach& within) const
{
    PictureReach reach{.left = within.right, .right = within.left, .top = within.bottom, .bottom = within.top};
    for (const Run& run : m_runs[index]) {
        const int begin = std::max(run.begin, within.left);
        const int end = std::min(run.end, within.right);
        if (begin < end && run.row >= within.top && run.row < within.bottom) {
            reach.left = std::min(reach.left, begin);
            reach.right = std::max(reach.right, end);
            reach.top = std::min(reach.top, run.row);
            reach.bottom = std::max(reach.bottom, run.row + 1);
        }
    }
    return reach.isEmpty() ? PictureReach{} : reach;
}

OutlierCut cutOutliers(const SmokeTally& tally, const PictureReach& window, double share, double most)
{
    const PictureReach whole = tally.whole();
    const SummedArea sums(tally.weights(), whole.right, whole.bottom);
    const std::uint64_t total = sums.of(window);
    if (total == 0) {
        return {};
    }
    const std::uint64_t allowed = shareOf(total, std::min(share, most));
    const std::uint64_t limit = shareOf(total, most);
    PictureReach reach = window;
    std::uint64_t lost = 0;
    while (const std::optional<Strip> strip = bestStrip(sums, reach, limit - lost)) {
        if (lost + strip->weight > allowed) {
            break;
        }
        reach = strip->left;
        lost += strip->weight;
    }
    return {reach, static_cast<double>(lost) / static_cast<double>(total)};
}

DepthTally::DepthTally()
    : m_weights(kDepthBins)
{
}

void DepthTally::add(float depth, double weight)
{
    assert(depth > 0.0F);
    m_weights[std::bit_cast<std::uint32_t>(depth) >> kDepthBits] += weight;
    m_total += weight;
}

DepthRange DepthTally::without(const DepthRange& range, double share) const
{
    if (!(m_total > 0.0)) {
        return range;
    }
    const double most = share * m_total;
    const auto edge = [](std::size_t bin) {
        return std::bit_cast<float>(static_cast<std::uint32_t>(bin) << kDepthBits);
    };
    std::size_t low = 0;
    for (double before = m_weights[low]; before <= most && low + 1 < kDepthBins; before += m_weights[low]) {
        ++low;
    }
    std::size_t high = kDepthBins - 1;
    for (double behind = m_weights[high]; behind <= most && high > low; behind += m_weights[high]) {
        --high;
    }
    const float nearest = edge(low);
    const float farthest = edge(high + 1);
    return {std::clamp(range.nearest, nearest, farthest), std::clamp(range.farthest, nearest, farthest),
        std::clamp(range.middle, nearest, farthest)};
}

} // namespace fumage
