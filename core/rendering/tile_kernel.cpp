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

void paint(const SpriteBatch& batch, const SpriteTexture& texture, std::span<const DepthEntry> entries, Tile& tile, Image& image)
{
    clearTile(tile);
    const bool shaded = batch.style.relief != 0.0F || batch.style.roundness != 0.0F;
    const auto paintSprite = batch.style.square ? (shaded ? paintTextured<true, true> : paintTextured<true, false>) : (shaded ? paintTextured<false, true> : paintTextured<false, false>);
    constexpr std::size_t kBetweenLooks = 32;
    constexpr std::size_t kAhead = 12;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (i % kBetweenLooks == 0 && i > 0 && isOpaque(tile)) {
            break;
        }
        if (i + kAhead < entries.size()) {
            hwy::Prefetch(&batch.sprites[entryIndex(entries[i + kAhead])]);
        }
        const Sprite& sprite = batch.sprites[entryIndex(entries[i])];
        if (unpackTexture(sprite.texture).level == TextureRef::kPlain) {
            paintPlainSprite(batch.style, sprite, tile);
        } else {
            paintSprite(batch.style, texture, sprite, tile);
        }
    }
    writeTile(tile, image);
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(paint);

void paintTile(const SpriteBatch& batch, const SpriteTexture& texture, std::span<const DepthEntry> entries, Tile& tile, Image& image)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(paint);
    kernel(batch, texture, entries, tile, image);
}

} // namespace fumage
#endif
