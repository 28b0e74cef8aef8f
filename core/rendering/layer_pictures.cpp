#include "core/rendering/layer_pictures.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <bit>

namespace fumage {

namespace {

/// A number from 0 to a whole as a multiple of the whole's ulp, the nearest. O(1).
float onGridOf(float whole, float number)
{
    // The power of two below the whole: floats from it on lie on the grid, and numbers below come onto it by its sum.
    constexpr std::uint32_t kExponent = 0x7f800000U;
    const auto power = std::bit_cast<float>(std::bit_cast<std::uint32_t>(whole) & kExponent);
    return number >= power ? number : (number + power) - power;
}

} // namespace

/// Paints the pictures in which the first layers have their colours, up to each of some.
/// @param last exclusive
Status LayerPictures::paint(
    SpriteLayers layers, std::size_t first, std::size_t last, int factor, const std::stop_token& stop)
{
    m_upTo.resize(std::max(m_upTo.size(), last - first));
    std::vector<RenderTarget> targets;
    for (std::size_t layer = first; layer < last; ++layer) {
        targets.push_back({nullptr, &m_upTo[layer - first], layer + 1});
    }
    if (targets.empty()) {
        return Done{};
    }
    if (Status status = m_compositor.composeAll(layers, targets, stop); !status) {
        return status;
    }
    for (const RenderTarget& target : targets) {
        if (factor > 1) {
            *target.image = downsample(*target.image, factor, stop);
        }
    }
    return stop.stop_requested() ? Status(Error{ErrorCode::Cancelled, makeMessage("painting was cancelled"), {}, {}})
                                 : Status(Done{});
}

void LayerPictures::takeFrom(const Image& upTo, const Image& whole)
{
    const std::size_t floats = static_cast<std::size_t>(whole.width) * 4;
    parallelFor(static_cast<std::size_t>(whole.height), [&](std::size_t y) {
        const float* all = whole.row(static_cast<int>(y));
        const float* some = upTo.row(static_cast<int>(y));
        float* before = m_before.row(static_cast<int>(y));
        float* share = m_share.row(static_cast<int>(y));
        for (std::size_t i = 0; i < floats; ++i) {
            const float now = onGridOf(all[i], some[i]);
            share[i] = now - before[i];
            before[i] = now;
        }
    });
}

Status LayerPictures::contributions(
    SpriteLayers layers, const Image& whole, int factor, const LayerTake& take, const std::stop_token& stop)
{
    m_before.resize(whole.width, whole.height);
    std::fill(m_before.pixels.begin(), m_before.pixels.end(), 0.0F);
    m_share.resize(whole.width, whole.height);
    const std::size_t last = layers.size() - 1; // which makes the picture whole
    for (std::size_t first = 0; first < layers.size(); first += kAtOnce) {
        const std::size_t end = std::min(first + kAtOnce, layers.size());
        if (Status status = paint(layers, first, std::min(end, last), factor, stop); !status) {
            return status;
        }
        for (std::size_t layer = first; layer < end; ++layer) {
            takeFrom(layer == last ? whole : m_upTo[layer - first], whole);
            take(layer, m_share);
        }
    }
    return Done{};
}

} // namespace fumage
