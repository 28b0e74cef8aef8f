#pragma once

#include "core/rendering/compositor.h"

#include <functional>
#include <vector>

namespace fumage {

/// Takes the picture of one layer; it is valid until the function returns.
/// @param layer its place among those that are drawn, from 0 on
using LayerTake = std::function<void(std::size_t layer, const Image& picture)>;

/// Divides a picture among its layers.
///
/// The contribution of a layer is the picture with the colours of all other layers black: these hide what they hide,
/// and give nothing ("holdout"). Its alpha is what the layer covers that nothing in front of it does.
///
/// With P(k) the picture in which the first k layers have their colours, and S(k) that rounded to the grid of the
/// picture's float, q = ulp(P(n)), the contribution is S(k) - S(k-1). Each is a whole multiple of q between 0 and the
/// picture, which is less than 2^24 q: it is a float, and so is every sum of some of them. Hence they add up to the
/// picture to the bit, in whatever order. P(k) does not fall with k, since neither sums, products nor means of floats
/// do: no contribution is less than 0. It is exact to a few ulps of the picture.
///
/// Keeps its buffers: kAtOnce pictures of the size that sprites are made for, and three of the size that is written,
/// however many layers there are. Not thread-safe; uses all threads inside.
class LayerPictures {
public:
    /// Layers that are painted at once.
    static constexpr std::size_t kAtOnce = 4;

    /// Hands out the contribution of each layer, in their order.
    /// @param layers of the picture, at supersample times its size
    /// @param whole  the picture that they make, as Compositor and downsample() give it; not changed
    /// @param factor supersample
    /// @error Cancelled
    /// As many compositions as there are kAtOnce layers; of one layer none: its contribution is the picture. The same
    /// bits for any thread count and instruction set.
    [[nodiscard]] Status contributions(
        SpriteLayers layers, const Image& whole, int factor, const LayerTake& take, const std::stop_token& stop = {});

private:
    [[nodiscard]] Status paint(
        SpriteLayers layers, std::size_t first, std::size_t last, int factor, const std::stop_token& stop);
    void takeFrom(const Image& upTo, const Image& whole);

    Compositor m_compositor;
    std::vector<Image> m_upTo; ///< the picture with the colours of the first layers alone
    Image m_before; ///< what the layers before have been given
    Image m_share;
};

} // namespace fumage
