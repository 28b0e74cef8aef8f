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
    for (std::size_t patch = 0; patch < tile.patches.size(); patch += Tile::kPatchFloats) {
        std::fill_n(tile.patches.begin() + static_cast<std::ptrdiff_t>(patch), Tile::kPatchPixels, 1.0F);
        std::fill_n(tile.patches.begin() + static_cast<std::ptrdiff_t>(patch + Tile::kPatchPixels), Tile::kPatchFloats - Tile::kPatchPixels, 0.0F);
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

/// Past the cache where rows of the image lie on its lines: nothing reads it before the whole picture, which is larger than the cache, is done.
void writeTile(const Tile& tile, Image& image)
{
    const D d;
    const int width = tile.right - tile.left;
    alignas(kAlignment) float line[static_cast<std::size_t>(Compositor::kTileWidth) * 4]; // NOLINT(cppcoreguidelines-avoid-c-arrays): not initialised
    const bool whole = image.width % Tile::kPatch == 0;
    for (int y = 0; y < tile.bottom - tile.top; ++y) {
        float* HWY_RESTRICT to = image.row(tile.top + y) + static_cast<std::size_t>(tile.left) * 4;
        joinRow(tile.patches.data() + patchOffset(0, y / Tile::kPatch) + static_cast<std::size_t>(y % Tile::kPatch * Tile::kPatch), width, line);
        if (whole) {
            for (std::size_t i = 0; i < static_cast<std::size_t>(width) * 4; i += hn::Lanes(d)) {
                hn::Stream(hn::Load(d, line + i), d, to + i);
            }
        } else {
            std::copy_n(line, static_cast<std::size_t>(width) * 4, to);
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
