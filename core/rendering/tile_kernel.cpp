#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/rendering/tile_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "core/rendering/coherent_sprite-inl.h"
#include "core/rendering/pictured_sprite-inl.h"
#include "core/rendering/plain_sprite-inl.h"
#include "core/rendering/textured_sprite-inl.h"
#include "core/rendering/tile_kernel.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Nothing yet in the way of anything. What lies beyond the image's edge counts as covered, or the last tiles would
/// never be full.
void clearTile(const OtherTargets& others, Tile& tile)
{
    const D d;
    tile.others.resize(std::max(tile.others.size(), others.stride() * Tile::kPatches));
    std::fill_n(tile.others.data(), others.stride() * Tile::kPatches, 0.0F);
    for (std::size_t target = 0; target < others.count; ++target) {
        for (std::size_t patch = 0; others.targets[target].layers == nullptr && patch < Tile::kPatches; ++patch) {
            std::fill_n(
                tile.others.data() + patch * others.stride() + target * Tile::kPatchFloats, Tile::kPatchPixels, 1.0F);
        }
    }
    for (std::size_t patch = 0; patch < tile.patches.size(); patch += Tile::kPatchFloats) {
        for (std::size_t i = 0; i < Tile::kPatchFloats; i += hn::Lanes(d)) {
            hn::Store(i < Tile::kPatchPixels ? hn::Set(d, 1.0F) : hn::Zero(d), d, tile.patches.data() + patch + i);
        }
    }
    const int width = tile.right - tile.left;
    const int height = tile.bottom - tile.top;
    if (width == Tile::kWidth && height == Tile::kHeight) {
        return;
    }
    for (int y = 0; y < Tile::kHeight; ++y) {
        for (int x = y < height ? width : 0; x < Tile::kWidth; ++x) {
            tile.patches[patchOffset(x / Tile::kPatch, y / Tile::kPatch)
                + static_cast<std::size_t>(y % Tile::kPatch * Tile::kPatch + x % Tile::kPatch)] = 0.0F;
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

/// The planes of one target in a tile.
struct Planes {
    const float* through;
    std::size_t throughStride; ///< from one patch to the next
    const float* colours; ///< red, green and blue
    std::size_t stride; ///< of colours, from one patch to the next

    [[nodiscard]] Planes at(int column, int row) const
    {
        const auto patch = static_cast<std::size_t>(row * Tile::kAcross + column);
        return {through + patch * throughStride, throughStride, colours + patch * stride, stride};
    }
    void next()
    {
        through += throughStride;
        colours += stride;
    }
};

/// Puts a row of the image together from its planes.
/// @param line of the patch
void joinRow(Planes from, std::size_t line, int width, float* HWY_RESTRICT to)
{
    const hn::CappedTag<float, Tile::kPatch> d;
    const auto one = hn::Set(d, 1.0F);
    for (int x = 0; x < width; x += Tile::kPatch, from.next()) {
        for (std::size_t i = line * Tile::kPatch; i < (line + 1) * Tile::kPatch;
             i += hn::Lanes(d), to += 4 * hn::Lanes(d)) {
            const auto plane = [&](std::size_t number)
                                   HWY_ATTR { return hn::LoadU(d, from.colours + number * Tile::kPatchPixels + i); };
            hn::StoreInterleaved4(plane(0), plane(1), plane(2), hn::Sub(one, hn::LoadU(d, from.through + i)), d, to);
        }
    }
}

#if HWY_TARGET != HWY_SCALAR

/// Writes rows of four pixels: block i of each vector is one pixel of row i.
template <class DRows, class VRows>
HWY_INLINE void streamRows(
    DRows d, VRows first, VRows second, VRows third, VRows fourth, float* HWY_RESTRICT to, std::size_t stride)
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
        streamRows(half, hn::LowerHalf(half, first), hn::LowerHalf(half, second), hn::LowerHalf(half, third),
            hn::LowerHalf(half, fourth), to, stride);
        to += hn::Lanes(half) / kBlock * stride;
        streamRows(half, hn::UpperHalf(half, first), hn::UpperHalf(half, second), hn::UpperHalf(half, third),
            hn::UpperHalf(half, fourth), to, stride);
    }
}

/// Puts a patch of the image together from its planes.
/// @param stride floats from one row of the image to the next
HWY_INLINE void streamPatch(const Planes& from, float* HWY_RESTRICT to, std::size_t stride)
{
    const D d;
    const hn::Repartition<double, D> pairs;
    for (std::size_t part = 0; part < Tile::kPatchPixels;
         part += hn::Lanes(d), to += hn::Lanes(d) / Tile::kPatch * stride) {
        const auto plane = [&](std::size_t number)
                               HWY_ATTR { return hn::Load(d, from.colours + number * Tile::kPatchPixels + part); };
        const V alpha = hn::Sub(hn::Set(d, 1.0F), hn::Load(d, from.through + part));
        const auto lowRg = hn::BitCast(pairs, hn::InterleaveLower(d, plane(0), plane(1)));
        const auto highRg = hn::BitCast(pairs, hn::InterleaveUpper(d, plane(0), plane(1)));
        const auto lowBa = hn::BitCast(pairs, hn::InterleaveLower(d, plane(2), alpha));
        const auto highBa = hn::BitCast(pairs, hn::InterleaveUpper(d, plane(2), alpha));
        streamRows(d, hn::BitCast(d, hn::InterleaveLower(pairs, lowRg, lowBa)),
            hn::BitCast(d, hn::InterleaveUpper(pairs, lowRg, lowBa)),
            hn::BitCast(d, hn::InterleaveLower(pairs, highRg, highBa)),
            hn::BitCast(d, hn::InterleaveUpper(pairs, highRg, highBa)), to, stride);
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

/// Past the cache where that can be: nothing reads the image before the whole picture, which is larger than the cache,
/// is done.
void writeTile(const Tile& tile, const Planes& planes, Image& image)
{
    const int width = tile.right - tile.left;
    const int height = tile.bottom - tile.top;
    int y = 0;
#if HWY_TARGET != HWY_SCALAR
    if (hasWholePatches(image)) {
        const std::size_t stride = static_cast<std::size_t>(image.width) * 4;
        for (; y + Tile::kPatch <= height; y += Tile::kPatch) {
            Planes from = planes.at(0, y / Tile::kPatch);
            float* to = pixelsOf(tile, image, y);
            for (int x = 0; x < width; x += Tile::kPatch, from.next(), to += Tile::kPatchPixels) {
                streamPatch(from, to, stride);
            }
        }
    }
#endif
    for (; y < height; ++y) {
        alignas(kAlignment) float line[static_cast<std::size_t>(Tile::kWidth)
            * 4]; // NOLINT(cppcoreguidelines-avoid-c-arrays): not initialised
        joinRow(planes.at(0, y / Tile::kPatch), static_cast<std::size_t>(y % Tile::kPatch), width, line);
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

using PaintTextured = void (*)(const SpriteStyle& style, const SpriteTexture& texture, const Sprite& sprite,
    const SpriteInTargets& others, Tile& tile);

template <bool kManyTargets>
PaintTextured painterOf(const SpriteStyle& style)
{
    const bool isShaded = style.relief != 0.0F || style.roundness != 0.0F;
    if (style.square) {
        return isShaded ? paintTextured<true, true, kManyTargets> : paintTextured<true, false, kManyTargets>;
    }
    return isShaded ? paintTextured<false, true, kManyTargets> : paintTextured<false, false, kManyTargets>;
}

/// Calls paintSprite(number) near to far, until nothing behind can be seen.
template <class PaintSprite>
HWY_INLINE void forEntries(SpriteLayers layers, const OtherTargets& others, std::span<const DepthEntry> entries,
    const Tile& tile, const PaintSprite& paintSprite)
{
    constexpr std::size_t kBetweenLooks = 32;
    constexpr std::size_t kAhead = 12;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (i % kBetweenLooks == 0 && i > 0 && isOpaque(tile)) {
            break;
        }
        if (i + kAhead < entries.size()) {
            // Here and not in a function: GCC takes one that only fetches for one without effect, and leaves out its
            // calls.
            const SpriteNumber next(entryIndex(entries[i + kAhead]));
            const SpriteBatch& batch = *layers[next.layer()].batch;
            hwy::Prefetch(&batch.sprites[next.slot()]);
            if (!batch.details.empty()) {
                hwy::Prefetch(&batch.details[next.slot()].phases[0]);
                hwy::Prefetch(&batch.details[next.slot()].strength);
            }
            for (std::size_t target = 0; target < others.count; ++target) {
                if (others.targets[target].layers != nullptr) {
                    hwy::Prefetch(others.colourOf(target, next));
                }
            }
        }
        paintSprite(SpriteNumber(entryIndex(entries[i])));
    }
}

/// Paints the sprites' own colours and those of the other targets.
template <bool kManyTargets>
void paintAll(SpriteLayers layers, const OtherTargets& others, std::span<const DepthEntry> entries, Tile& tile)
{
    std::array<PaintTextured, SpriteNumber::kMaxLayers> withTexture; // NOLINT: as many as there are layers are set
    for (std::size_t i = 0; i < layers.size(); ++i) {
        withTexture[i] = painterOf<kManyTargets>(layers[i].batch->style);
    }
    const DetailTexture& detail = DetailTexture::instance();
    forEntries(layers, others, entries, tile, [&](SpriteNumber number) HWY_ATTR {
        const SpriteLayer& layer = layers[number.layer()];
        const SpriteBatch& batch = *layer.batch;
        const Sprite& sprite = batch.sprites[number.slot()];
        const SpriteInTargets inTargets{others, number};
        if (isCoherent(batch, number.slot())) {
            paintCoherentSprite<kManyTargets>(batch, detail, number.slot(), inTargets, tile);
        } else if (layer.picture != nullptr) {
            paintPictured<kManyTargets>(batch.style, *layer.picture, sprite, inTargets, tile);
        } else if (unpackTexture(sprite.texture).level == TextureRef::kPlain) {
            paintPlainSprite<kManyTargets>(batch.style, sprite, inTargets, tile);
        } else {
            withTexture[number.layer()](batch.style, *layer.texture, sprite, inTargets, tile);
        }
    });
}

void paint(SpriteLayers layers, std::span<const RenderTarget> targets, std::span<const DepthEntry> entries, Tile& tile)
{
    if (entries.empty()) {
        for (const RenderTarget& target : targets) {
            writeNothing(tile, *target.image);
        }
        return;
    }
    const OtherTargets others(targets);
    clearTile(others, tile);
    if (others.count > 0) {
        paintAll<true>(layers, others, entries, tile);
    } else {
        paintAll<false>(layers, others, entries, tile);
    }
    const float* const through = tile.patches.data();
    const float* other = tile.others.data();
    for (const RenderTarget& target : targets) {
        const Planes whole{through, Tile::kPatchFloats, through + Tile::kPatchPixels, Tile::kPatchFloats};
        if (target.isWhole()) {
            writeTile(tile, whole, *target.image);
            continue;
        }
        const Planes own{other, others.stride(), other + Tile::kPatchPixels, others.stride()};
        const bool hasOwnAlpha = target.colours == nullptr;
        writeTile(
            tile, hasOwnAlpha ? own : Planes{through, Tile::kPatchFloats, own.colours, own.stride}, *target.image);
        other += Tile::kPatchFloats;
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(paint);

void paintTile(
    SpriteLayers layers, std::span<const RenderTarget> targets, std::span<const DepthEntry> entries, Tile& tile)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(paint);
    kernel(layers, targets, entries, tile);
}

} // namespace fumage
#endif
