#include "core/export/sheets/sheet_preview.h"

#include "core/base/memory.h"
#include "core/export/sheets/cell_frames.h"
#include "core/export/sheets/sheet.h"
#include "core/rendering/compositor.h"
#include "core/rendering/view_transform.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fumage {

namespace {

/// Makes cells no larger than is allowed.
/// @return whether they stay as they are
bool shrink(Output& output, int cells, int mostEdge, std::int64_t mostPixels)
{
    const double edges = static_cast<double>(mostEdge) / std::max(output.width, output.height);
    const double pixels = static_cast<double>(mostPixels) / (static_cast<double>(output.width) * output.height * cells);
    const double scale = std::min(edges, std::sqrt(pixels));
    if (scale >= 1.0) {
        return true;
    }
    const auto scaled = [&](int edge) { return std::max(1, static_cast<int>(edge * scale)); };
    output.width = scaled(output.width);
    output.height = scaled(output.height);
    return false;
}

/// Linear light of the bytes of sRGB.
std::array<float, 256> linearOfBytes()
{
    std::array<float, 256> out{};
    for (std::size_t i = 0; i < out.size(); ++i) {
        out[i] = linearFromSrgb(static_cast<float>(i) / 255.0F);
    }
    return out;
}

/// Makes of the sheet's colours what an engine has of them.
void storeColours(const Scene& scene, ImageFormat format, SheetPreview& preview)
{
    Image& colour = preview.sheet.targets.targets[static_cast<std::size_t>(PassTarget::Colour)];
    if (holdsFloats(format)) {
        if (scene.output.background != Background::Transparent) {
            fillBackground(colour, scene.output.backgroundColour);
        }
        return;
    }
    EncodedImage<std::uint8_t> encoded;
    encode(colour, scene.output, encoded, coverOf(scene));
    const std::array<float, 256> linear = linearOfBytes();
    for (std::size_t i = 0; i < encoded.pixels.size(); i += 4) {
        const float alpha = static_cast<float>(encoded.pixels[i + 3]) / 255.0F;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            colour.pixels[i + channel] = linear[encoded.pixels[i + channel]] * alpha;
        }
        colour.pixels[i + 3] = alpha;
    }
    // An engine shows them as they are.
    preview.output.exposure = 0.0F;
    preview.output.viewTransform = ViewTransform::Standard;
}

} // namespace

Result<std::shared_ptr<const SheetPreview>> previewFlipbook(
    const Scene& scene, const ExportPlan& plan, int mostEdge, std::int64_t mostPixels, const ExportTask& asked)
{
    return withinMemory([&]() -> Result<std::shared_ptr<const SheetPreview>> {
        const ExportTask task = withShelf(asked);
        Result<Scene> seen = sceneSeenBy(scene, plan, task);
        if (!seen) {
            return seen.error();
        }
        const FlipbookOptions whole = flipbookOf(plan);
        auto preview = std::make_shared<SheetPreview>();
        preview->isWhole = shrink(seen.value().output, whole.columns * whole.rows, mostEdge, mostPixels);
        const Result<FlipbookOptions> made = flipbookSeenBy(seen.value(), plan, task);
        if (!made) {
            return made.error();
        }
        const FlipbookOptions& options = made.value();
        preview->output = seen.value().output;
        preview->cellsPerSecond = cellsPerSecond(seen.value(), options);
        PassSet passes{Pass::Colour};
        const bool motion = options.passes.has(Pass::Motion);
        if (motion) {
            passes.add(Pass::Motion);
        }
        if (Status status = renderSheet(
                seen.value(), cellFramesOf(seen.value(), options), options.columns, passes, preview->sheet, {}, task);
            !status) {
            return status.error();
        }
        storeColours(seen.value(), options.format, *preview);
        if (motion) {
            const PassPictures pictures(preview->sheet, {Pass::Motion}, {});
            preview->playback = std::make_unique<SheetPlayback>(
                preview->sheet, stored(pictures.picture(Pass::Motion), options.format), pictures.scales().motion);
        } else {
            preview->playback = std::make_unique<SheetPlayback>(preview->sheet);
        }
        return std::shared_ptr<const SheetPreview>(std::move(preview));
    });
}

} // namespace fumage
