#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/rendering/tile_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "core/rendering/plain_sprite-inl.h"
#include "core/rendering/textured_sprite-inl.h"
#include "core/rendering/tile_kernel.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Nothing yet in the way of anything. What lies beyond the image's edge counts as covered, or the last tiles would never be full.
void clearTile(Tile& tile)
{
    const D d;
    for (std::size_t patch = 0; patch < tile.patches.size(); patch += Tile::kPatchFloats) {
        for (std::size_t i = 0; i < Tile::kPatchFloats; i += hn::Lanes(d)) {
            hn::Store(i < Tile::kPatchPixels ? hn::Set(d, 1.0F) : hn::Zero(d), d, tile.patches.data() + patch + i);
        }
    }
    const int width = tile.right - tile.left;
    const int height = tile.bottom - tile.top;
    if (width == Compositor::kTileWidth && height == Compositor::kTileHeight) {
        return;
    }
    for (int y = 0; y < Compositor::kTileHeight; ++y) {
        for (int x = y < height ? width : 0; x < Compositor::kTileWidth; ++x) {
            tile.patches[patchOffset(x / Tile::kPatch, y / Tile::kPatch) + static_cast<std::size_t>(y % Tile::kPatch * Tile::kPatch + x % Tile::kPatch)] = 0.0F;
        }
    }
}

bool isOpaque(const Tile& tile)
{
    const D d;
    constexpr float kInvisible = 1.0F / 1024.0F;
    const V limit = hn::Set(d, kInvisible);
    for (std::size_t patch = 0; patch < tile.patches.size(); patch += Tile::kPatchFloats) {
        for (std::size_t part = 0; part < Tile::kPatchPixels; part += hn::Lanes(d)) {
            if (!hn::AllTrue(d, hn::Lt(hn::Load(d, tile.patches.data() + patch + part), limit))) {
                return false;
            }
        }
    }
    return true;
}

/// Puts a row of the image together from its planes.
void joinRow(const float* HWY_RESTRICT from, int width, float* HWY_RESTRICT to)
{
    const hn::CappedTag<float, Tile::kPatch> d;
    const auto one = hn::Set(d, 1.0F);
    for (int x = 0; x < width; x += Tile::kPatch, from += Tile::kPatchFloats) {
        for (std::size_t i = 0; i < Tile::kPatch; i += hn::Lanes(d), to += 4 * hn::Lanes(d)) {
            const auto plane = [&](std::size_t number) HWY_ATTR { return hn::LoadU(d, from + number * Tile::kPatchPixels + i); };
            hn::StoreInterleaved4(plane(1), plane(2), plane(3), hn::Sub(one, plane(0)), d, to);
        }
    }
}

#if HWY_TARGET != HWY_SCALAR

/// Writes rows of four pixels: block i of each vector is one pixel of row i.
template <class DRows, class VRows>
HWY_INLINE void streamRows(DRows d, VRows first, VRows second, VRows third, VRows fourth, float* HWY_RESTRICT to, std::size_t stride)
{
    constexpr std::size_t kBlock = 4; // floats
    if constexpr (hn::MaxLanes(d) == kBlock) {
        hn::Stream(first, d, to);
        hn::Stream(second, d, to + kBlock);
        hn::Stream(third, d, to + 2 * kBlock);
        hn::Stream(fourth, d, to + 3 * kBlock);
    } else if constexpr (hn::MaxLanes(d) == 2 * kBlock) {
        hn::Stream(hn::ConcatLowerLower(d, second, first), d, to);
        hn::Stream(hn::ConcatLowerLower(d, fourth, third), d, to + 2 * kBlock);
        hn::Stream(hn::ConcatUpperUpper(d, second, first), d, to + stride);
        hn::Stream(hn::ConcatUpperUpper(d, fourth, third), d, to + stride + 2 * kBlock);
    } else {
        const hn::Half<DRows> half;
        streamRows(half, hn::LowerHalf(half, first), hn::LowerHalf(half, second), hn::LowerHalf(half, third), hn::LowerHalf(half, fourth), to, stride);
        to += hn::Lanes(half) / kBlock * stride;
        streamRows(half, hn::UpperHalf(half, first), hn::UpperHalf(half, second), hn::UpperHalf(half, third), hn::UpperHalf(half, fourth), to, stride);
    }
}

/// Puts a patch of the image together from its planes.
/// @param stride floats from one row of the image to the next
HWY_INLINE void streamPatch(const float* HWY_RESTRICT from, float* HWY_RESTRICT to, std::size_t stride)
{
    const D d;
    const hn::Repartition<double, D> pairs;
    for (std::size_t part = 0; part < Tile::kPatchPixels; part += hn::Lanes(d), to += hn::Lanes(d) / Tile::kPatch * stride) {
        const auto plane = [&](std::size_t number) HWY_ATTR { return hn::Load(d, from + number * Tile::kPatchPixels + part); };
        const V alpha = hn::Sub(hn::Set(d, 1.0F), plane(0));
        const auto lowRg = hn::BitCast(pairs, hn::InterleaveLower(d, plane(1), plane(2)));
        const auto highRg = hn::BitCast(pairs, hn::InterleaveUpper(d, plane(1), plane(2)));
        const auto lowBa = hn::BitCast(pairs, hn::InterleaveLower(d, plane(3), alpha));
        const auto highBa = hn::BitCast(pairs, hn::InterleaveUpper(d, plane(3), alpha));
        streamRows(d, hn::BitCast(d, hn::InterleaveLower(pairs, lowRg, lowBa)), hn::BitCast(d, hn::InterleaveUpper(pairs, lowRg, lowBa)),
            hn::BitCast(d, hn::InterleaveLower(pairs, highRg, highBa)), hn::BitCast(d, hn::InterleaveUpper(pairs, highRg, highBa)), to, stride);
    }
}

#endif

/// Whether rows of the image lie on cache lines as patches do.
bool hasWholePatches(const Image& image)
{
    return image.width % Tile::kPatch == 0;
}

float* pixelsOf(const Tile& tile, Image& image, int row)
{
    return image.row(tile.top + row) + static_cast<std::size_t>(tile.left) * 4;
}

/// Past the cache where that can be: nothing reads the image before the whole picture, which is larger than the cache, is done.
void writeTile(const Tile& tile, Image& image)
{
    const int width = tile.right - tile.left;
    const int height = tile.bottom - tile.top;
    int y = 0;
#if HWY_TARGET != HWY_SCALAR
    if (hasWholePatches(image)) {
        const std::size_t stride = static_cast<std::size_t>(image.width) * 4;
        for (; y + Tile::kPatch <= height; y += Tile::kPatch) {
            const float* from = tile.patches.data() + patchOffset(0, y / Tile::kPatch);
            float* to = pixelsOf(tile, image, y);
            for (int x = 0; x < width; x += Tile::kPatch, from += Tile::kPatchFloats, to += Tile::kPatchPixels) {
                streamPatch(from, to, stride);
            }
        }
    }
#endif
    for (; y < height; ++y) {
        alignas(kAlignment) float line[static_cast<std::size_t>(Compositor::kTileWidth) * 4]; // NOLINT(cppcoreguidelines-avoid-c-arrays): not initialised
        joinRow(tile.patches.data() + patchOffset(0, y / Tile::kPatch) + static_cast<std::size_t>(y % Tile::kPatch * Tile::kPatch), width, line);
        std::copy_n(line, static_cast<std::size_t>(width) * 4, pixelsOf(tile, image, y));
    }
    hwy::FlushStream();
}

/// What writeTile() writes when nothing was painted.
void writeNothing(const Tile& tile, Image& image)
{
    const D d;
    const std::size_t floats = static_cast<std::size_t>(tile.right - tile.left) * 4;
    for (int y = 0; y < tile.bottom - tile.top; ++y) {
        float* HWY_RESTRICT to = pixelsOf(tile, image, y);
        if (!hasWholePatches(image)) {
            std::fill_n(to, floats, 0.0F);
            continue;
        }
        for (std::size_t i = 0; i < floats; i += hn::Lanes(d)) {
            hn::Stream(hn::Zero(d), d, to + i);
        }
    }
    hwy::FlushStream();
}

/// What lights the inside of the sprites of a picture.
Shading shadingOf(const SpriteStyle& style, const SpriteLayer* layer)
{
    if (style.relief == 0.0F && style.roundness == 0.0F) {
        return Shading::None;
    }
    return layer == nullptr ? Shading::Sun : layer->light == LayerLight::Flat ? Shading::None
                                                                              : Shading::Axes;
}

/// Those of the batch, under the lights of a layer.
SpriteStyle styleOf(const SpriteBatch& batch, const SpriteLayer* layer)
{
    SpriteStyle style = batch.style;
    if (layer != nullptr) {
        // What comes from the right goes to the left; y runs down.
        style.lightX = layer->light == LayerLight::RightTopBack ? -1.0F : 1.0F;
        style.lightY = -style.lightX;
    }
    return style;
}

using PaintTextured = void (*)(const SpriteStyle& style, const SpriteTexture& texture, const Sprite& sprite, Tile& tile);

template <bool kSquare>
PaintTextured painterOf(Shading shading)
{
    switch (shading) {
    case Shading::None: break;
    case Shading::Sun: return paintTextured<kSquare, Shading::Sun>;
    case Shading::Axes: return paintTextured<kSquare, Shading::Axes>;
    }
    return paintTextured<kSquare, Shading::None>;
}

/// Calls paintSprite(index) near to far, until nothing behind can be seen.
template <class PaintSprite, class FetchSprite>
HWY_INLINE void forEntries(std::span<const DepthEntry> entries, const Tile& tile, const PaintSprite& paintSprite, const FetchSprite& fetchSprite)
{
    constexpr std::size_t kBetweenLooks = 32;
    constexpr std::size_t kAhead = 12;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (i % kBetweenLooks == 0 && i > 0 && isOpaque(tile)) {
            break;
        }
        if (i + kAhead < entries.size()) {
            fetchSprite(entryIndex(entries[i + kAhead]));
        }
        paintSprite(entryIndex(entries[i]));
    }
}

void paint(const SpriteBatch& batch, const SpriteTexture& texture, const SpriteLayer* layer, std::span<const DepthEntry> entries, Tile& tile, Image& image)
{
    if (entries.empty()) {
        writeNothing(tile, image);
        return;
    }
    clearTile(tile);
    const Shading shading = shadingOf(batch.style, layer);
    const SpriteStyle style = styleOf(batch, layer);
    const PaintTextured paintWithTexture = style.square ? painterOf<true>(shading) : painterOf<false>(shading);
    const auto paintSprite = [&](const Sprite& sprite) HWY_ATTR {
        if (unpackTexture(sprite.texture).level == TextureRef::kPlain) {
            paintPlainSprite(style, sprite, tile);
        } else {
            paintWithTexture(style, texture, sprite, tile);
        }
    };
    const auto fetch = [&](std::uint32_t index) HWY_ATTR { hwy::Prefetch(&batch.sprites[index]); };
    if (layer == nullptr) {
        forEntries(
            entries, tile, [&](std::uint32_t index) HWY_ATTR { paintSprite(batch.sprites[index]); }, fetch);
    } else {
        forEntries(
            entries, tile, [&](std::uint32_t index) HWY_ATTR {
                Sprite sprite = batch.sprites[index];
                std::copy_n(layer->colours.data() + std::size_t{index} * SpriteLayer::kStride, std::size(sprite.direct), sprite.direct);
                std::fill_n(sprite.ambient, std::size(sprite.ambient), 0.0F);
                paintSprite(sprite); },
            [&](std::uint32_t index) HWY_ATTR {
                fetch(index);
                hwy::Prefetch(layer->colours.data() + std::size_t{index} * SpriteLayer::kStride);
            });
    }
    writeTile(tile, image);
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(paint);

void paintTile(const SpriteBatch& batch, const SpriteTexture& texture, const SpriteLayer* layer, std::span<const DepthEntry> entries, Tile& tile, Image& image)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(paint);
    kernel(batch, texture, layer, entries, tile, image);
}

} // namespace fumage
#endif
