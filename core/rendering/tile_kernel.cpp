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

void clearTile(Tile& tile)
{
    std::fill_n(tile.planes.begin(), Tile::kPixels, 1.0F);
    std::fill(tile.planes.begin() + Tile::kPixels, tile.planes.end(), 0.0F);
}

bool isOpaque(const Tile& tile)
{
    const D d;
    constexpr float kInvisible = 1.0F / 1024.0F;
    const V limit = hn::Set(d, kInvisible);
    for (int y = tile.top; y < tile.bottom; ++y) {
        const float* row = tile.planes.data() + tileOffset(tile, tile.left, y);
        for (std::size_t i = 0; i < static_cast<std::size_t>(Compositor::kTileWidth); i += hn::Lanes(d)) {
            if (!hn::AllTrue(d, hn::Lt(hn::LoadU(d, row + i), limit))) {
                return false;
            }
        }
    }
    return true;
}

void writeTile(const Tile& tile, Image& image)
{
    for (int y = tile.top; y < tile.bottom; ++y) {
        float* HWY_RESTRICT to = image.row(y) + static_cast<std::size_t>(tile.left) * 4;
        const float* HWY_RESTRICT from = tile.planes.data() + tileOffset(tile, tile.left, y);
        const auto width = static_cast<std::size_t>(tile.right - tile.left);
        for (std::size_t i = 0; i < width; ++i) {
            to[i * 4] = from[i + Tile::kPixels];
            to[i * 4 + 1] = from[i + 2 * Tile::kPixels];
            to[i * 4 + 2] = from[i + 3 * Tile::kPixels];
            to[i * 4 + 3] = 1.0F - from[i];
        }
    }
}

void paint(const SpriteBatch& batch, const SpriteTexture& texture, std::span<const DepthEntry> entries, Tile& tile, Image& image)
{
    // Columns beyond the image's edge count as covered, or the last tile would never be full.
    clearTile(tile);
    for (int y = tile.top; y < tile.bottom && tile.right - tile.left < Compositor::kTileWidth; ++y) {
        for (int x = tile.right; x < tile.left + Compositor::kTileWidth; ++x) {
            tile.planes[tileOffset(tile, x, y)] = 0.0F;
        }
    }
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
    HWY_DYNAMIC_DISPATCH(paint)
    (batch, texture, entries, tile, image);
}

} // namespace fumage
#endif
