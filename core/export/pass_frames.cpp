#include "core/export/pass_frames.h"

#include "core/export/layer_masks.h"
#include "core/image_io/exr_file.h"
#include "core/rendering/compositor.h"

#include <algorithm>
#include <deque>
#include <iterator>

namespace fumage {

namespace {

/// Letters of a pass's channels, as Blender and Nuke name them.
std::string lettersOf(Pass pass)
{
    switch (pass) {
    case Pass::Motion: // Blender reads targets of one, three and four channels, and leaves out one of two
    case Pass::Normal: return "XYZ";
    case Pass::Depth: return "Z";
    case Pass::Alpha:
    case Pass::Density:
    case Pass::Temperature:
    case Pass::Shadow: return "Y";
    default: return "RGBA";
    }
}

/// What was divided to lie between 0 and 1 is multiplied again.
void unscale(Pass pass, const PassScales& scales, DataImage& image)
{
    const auto everyColour = [&](float scale) {
        for (std::size_t i = 0; i < image.values.size(); ++i) {
            image.values[i] *= i % 4 == 3 ? 1.0F : scale;
        }
    };
    switch (pass) {
    case Pass::SixWayA: everyColour(scales.light); break;
    case Pass::SixWayB:
        everyColour(scales.light);
        for (std::size_t i = 3; i < image.values.size(); i += 4) {
            image.values[i] = glowBrightness(image.values[i]) * scales.glow;
        }
        break;
    case Pass::Temperature:
        for (float& value : image.values) {
            value *= scales.temperature;
        }
        break;
    case Pass::Emission: everyColour(scales.emission); break;
    case Pass::Density:
        for (float& value : image.values) {
            value *= scales.density;
        }
        break;
    case Pass::Depth:
        for (float& value : image.values) {
            value = value * (scales.farthest - scales.nearest) + scales.nearest;
        }
        break;
    case Pass::Motion:
        for (std::size_t i = 0; i < image.values.size(); i += 3) {
            image.values[i] *= scales.motion * static_cast<float>(image.width);
            image.values[i + 1] *= scales.motion * static_cast<float>(image.height);
            image.values[i + 2] = 0.0F;
        }
        break;
    default: break;
    }
}

} // namespace

Result<std::vector<std::byte>> encodeTargets(const PassSheet& frame, PassSet passes, bool premultiplied,
    const Output& output, ImageFormat format, const ImageMetadata& notes, const std::stop_token& stop)
{
    // Vectors right and up, as those who composite expect them; light from the right, the top and behind, then from the
    // left, the bottom and the front.
    const PassPictures pictures(frame, passes, {SixWayLayout::Unity, VectorSigns::Unity, premultiplied});
    Image colour = frame.targets.of(PassTarget::Colour);
    if (output.background != Background::Transparent) {
        fillBackground(colour, output.backgroundColour);
    }
    ExrPixels pixels{colour.width, colour.height, {{{}, "RGBA", colour.pixels}}, format == ImageFormat::ExrHalf, notes};
    std::deque<DataImage> images; // which stay where they are
    for (const Pass pass : kAllPasses) {
        if (pass == Pass::Colour || pass == Pass::LayerMasks || !passes.has(pass)) {
            continue;
        }
        images.push_back(pictures.picture(pass));
        unscale(pass, pictures.scales(), images.back());
        pixels.targets.push_back({fileNameOf(pass), lettersOf(pass), images.back().values});
    }
    const std::vector<LayerMask> masks = storedMasks(frame, format);
    std::ranges::move(targetsOf(masks), std::back_inserter(pixels.targets));
    return encodeExr(pixels, stop);
}

Status checkTargets(const Scene& scene, PassSet passes, ImageFormat format)
{
    if (!holdsFloats(format)) {
        return Error{ErrorCode::OutOfRange, makeMessage("the passes of frames are layers of EXR"), {},
            makeMessage("Choose EXR, or a flipbook")};
    }
    if (!passes.has(Pass::LayerMasks)) {
        return Done{};
    }
    std::size_t channels = lettersOf(Pass::Colour).size();
    for (const Pass pass : kAllPasses) {
        const bool isPicture = pass != Pass::Colour && pass != Pass::LayerMasks;
        channels += isPicture && passes.has(pass) ? lettersOf(pass).size() : 0;
    }
    return checkMasks(scene, format, static_cast<std::int64_t>(scene.output.width) * scene.output.height, channels);
}

} // namespace fumage
