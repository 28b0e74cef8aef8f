// Included once per SIMD target: what the painters of sprites share, plain and textured.

#if defined(FUMAGE_TILE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_TILE_INL_H
#undef FUMAGE_TILE_INL_H
#else
#define FUMAGE_TILE_INL_H
#endif

#include "core/base/math-inl.h"
#include "core/rendering/tile_kernel.h"

#include <algorithm>
#include <cmath>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;

/// Rows and columns of the tile inside the box of a sprite; pixel centres lie at halves.
struct Box {
    int left, right, top, bottom; ///< inclusive
};

HWY_INLINE Box boxOf(const Sprite& sprite, const Tile& tile)
{
    const auto first = [](float edge) { return static_cast<int>(std::ceil(edge - 0.5F)); };
    const auto last = [](float edge) { return static_cast<int>(std::floor(edge - 0.5F)); };
    return {std::max(tile.left, first(std::max(sprite.x - sprite.halfWidth, -1e6F))), std::min(tile.right - 1, last(std::min(sprite.x + sprite.halfWidth, 1e6F))),
        std::max(tile.top, first(std::max(sprite.y - sprite.halfHeight, -1e6F))), std::min(tile.bottom - 1, last(std::min(sprite.y + sprite.halfHeight, 1e6F)))};
}

/// The rim p^2 + q^2 = 1 as xx dx^2 + 2 xy dx dy + yy dy^2 = 1.
struct Rim {
    float xx, xy, yy;

    explicit Rim(const Sprite& s)
        : xx(s.m00 * s.m00 + s.m10 * s.m10)
        , xy(s.m00 * s.m01 + s.m10 * s.m11)
        , yy(s.m01 * s.m01 + s.m11 * s.m11)
    {
    }
};

/// Adds a layer of opacity a and colour c under what is there.
template <class Tag, class W = hn::Vec<Tag>>
HWY_INLINE void under(Tag d, float* HWY_RESTRICT through, W a, W red, W green, W blue)
{
    float* HWY_RESTRICT toRed = through + Tile::kPixels;
    float* HWY_RESTRICT toGreen = through + 2 * Tile::kPixels;
    float* HWY_RESTRICT toBlue = through + 3 * Tile::kPixels;
    const W before = hn::LoadU(d, through);
    const W weight = hn::Mul(a, before);
    hn::StoreU(mulAdd(weight, red, hn::LoadU(d, toRed)), d, toRed);
    hn::StoreU(mulAdd(weight, green, hn::LoadU(d, toGreen)), d, toGreen);
    hn::StoreU(mulAdd(weight, blue, hn::LoadU(d, toBlue)), d, toBlue);
    hn::StoreU(hn::Sub(before, weight), d, through);
}

HWY_INLINE std::size_t tileOffset(const Tile& tile, int x, int y)
{
    return static_cast<std::size_t>(y - tile.top) * Tile::kStride + static_cast<std::size_t>(x - tile.left);
}

/// The same vector of pixels in two neighbouring rows: twice the independent work for a chain of operations that wait for one another.
template <class W>
struct RowsOf {
    W a, b;
};
using Rows = RowsOf<V>;

template <class W>
HWY_INLINE RowsOf<W> both(W v)
{
    return {v, v};
}

template <class W>
HWY_INLINE RowsOf<W> operator+(RowsOf<W> x, RowsOf<W> y)
{
    return {hn::Add(x.a, y.a), hn::Add(x.b, y.b)};
}

template <class W>
HWY_INLINE RowsOf<W> operator-(RowsOf<W> x, RowsOf<W> y)
{
    return {hn::Sub(x.a, y.a), hn::Sub(x.b, y.b)};
}

template <class W>
HWY_INLINE RowsOf<W> operator*(RowsOf<W> x, RowsOf<W> y)
{
    return {hn::Mul(x.a, y.a), hn::Mul(x.b, y.b)};
}

template <class W>
HWY_INLINE RowsOf<W> clampRows(RowsOf<W> x, W low, W high)
{
    return {hn::Min(hn::Max(x.a, low), high), hn::Min(hn::Max(x.b, low), high)};
}

/// dy of rows y, y + step, y + 2 step, ...; exact before the subtraction, so that they do not depend on the vector's width.
HWY_INLINE V rowOffsets(D d, int y, float step, float centre)
{
    return hn::Sub(hn::Add(hn::Mul(hn::Iota(d, 0.0F), hn::Set(d, step)), hn::Set(d, static_cast<float>(y) + 0.5F)), hn::Set(d, centre));
}

/// Room for one value a row of a tile, and for a pair of rows and a vector that run past its end.
constexpr std::size_t kRowRoom = roundUp(static_cast<std::size_t>(Compositor::kTileHeight) + 2, kAlignment / sizeof(float));

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
