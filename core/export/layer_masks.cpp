#include "core/export/layer_masks.h"

#include "core/base/parallel.h"
#include "core/export/layer_output.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace fumage {

namespace {

constexpr std::size_t kAlpha = 3;

/// A power of two in whose ulps halves of the size of a number are whole: added and taken away again it rounds to them,
/// to the nearest, and of two to the even one, as the number itself is rounded.
/// @param number in [0, 1]
float halfRounder(float number)
{
    constexpr std::uint32_t kExponent = 0x7f800000U;
    constexpr float kMinNormal = 0x1p-14F; // smaller halves have the steps of this one
    constexpr float kLongerBy = 0x1p13F; // bits that a float has more
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(std::max(number, kMinNormal)) & kExponent) * kLongerBy;
}

void roundToHalves(const PassSheet& sheet, std::vector<LayerMask>& masks)
{
    const Image& colour = sheet.targets.of(PassTarget::Colour);
    const auto width = static_cast<std::size_t>(colour.width);
    parallelFor(static_cast<std::size_t>(colour.height), [&](std::size_t y) {
        for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
            const float rounder = halfRounder(colour.pixels[i * 4 + kAlpha]);
            float sum = 0.0F;
            float before = 0.0F;
            for (LayerMask& mask : masks) {
                sum += mask.values[i];
                const float now = (sum + rounder) - rounder;
                mask.values[i] = now - before;
                before = now;
            }
        }
    });
}

} // namespace

std::vector<LayerMask> masksOf(const Scene& scene)
{
    std::vector<LayerMask> masks;
    for (WrittenLayer& layer : writtenLayers(scene)) {
        masks.push_back({std::move(layer.name), "mask_" + layer.word, {}});
    }
    return masks;
}

Status LayerMasks::place(
    PassSheet& sheet, int cell, const Image& picture, int supersample, SpriteLayers layers, const std::stop_token& stop)
{
    const SheetGrid& grid = sheet.grid;
    const auto width = static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.cellWidth);
    if (sheet.masks.empty()) {
        const auto rows = static_cast<std::size_t>((grid.cells + grid.columns - 1) / grid.columns);
        sheet.masks = m_empty;
        for (LayerMask& mask : sheet.masks) {
            mask.values.assign(width * rows * static_cast<std::size_t>(grid.cellHeight), 0.0F);
        }
    }
    const SheetCell at = grid.cell(cell);
    const auto take = [&](std::size_t layer, const Image& share) {
        parallelFor(static_cast<std::size_t>(share.height), [&](std::size_t y) {
            const float* from = share.row(static_cast<int>(y)) + kAlpha;
            float* to = sheet.masks[layer].values.data() + (static_cast<std::size_t>(at.top) + y) * width
                + static_cast<std::size_t>(at.left);
            for (int x = 0; x < share.width; ++x, from += 4) {
                *to++ = *from;
            }
        });
    };
    return m_pictures.contributions(layers, picture, supersample, take, stop);
}

std::string channelOf(const LayerMask& mask)
{
    return mask.target + "." + exrChannels(1);
}

Status checkMasks(const Scene& scene, ImageFormat format, std::int64_t pixels, std::size_t channels)
{
    if (!holdsFloats(format)) {
        return Error{ErrorCode::OutOfRange, makeMessage("the masks of layers are channels of EXR"), {},
            makeMessage("Choose EXR, or write alpha of layers as contribution")};
    }
    const std::size_t masks = masksOf(scene).size();
    if (pixels * static_cast<std::int64_t>(channels + masks) > static_cast<std::int64_t>(kMaxReadNumbers)) {
        return Error{ErrorCode::TooLarge, makeMessage("masks of %1 layers for %2 pixels", masks, pixels), {},
            makeMessage("Choose a smaller picture, or mute layers")};
    }
    return Done{};
}

std::vector<LayerMask> storedMasks(const PassSheet& sheet, ImageFormat format)
{
    std::vector<LayerMask> masks = sheet.masks;
    if (format == ImageFormat::ExrHalf) {
        roundToHalves(sheet, masks);
    }
    return masks;
}

std::vector<ExrChannels> targetsOf(const std::vector<LayerMask>& masks)
{
    std::vector<ExrChannels> targets;
    for (const LayerMask& mask : masks) {
        targets.push_back({mask.target, exrChannels(1), mask.values});
    }
    return targets;
}

Result<std::vector<std::byte>> encodeMasks(
    const PassSheet& sheet, ImageFormat format, const ImageMetadata& notes, const std::stop_token& stop)
{
    const std::vector<LayerMask> masks = storedMasks(sheet, format);
    const Image& colour = sheet.targets.of(PassTarget::Colour);
    return encodeExr(
        {colour.width, colour.height, targetsOf(masks), format == ImageFormat::ExrHalf, notes, false}, stop);
}

} // namespace fumage
