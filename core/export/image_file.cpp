#include "core/export/image_file.h"

#include "core/system/path.h"
#include "core/export/sheets/bleed.h"
#include "core/export/output_name.h"
#include "core/image_io/exr_file.h"
#include "core/image_io/png_file.h"
#include "core/image_io/tga_file.h"
#include "core/rendering/compositor.h"
#include "core/rendering/view_transform.h"

#include <algorithm>
#include <limits>
#include <span>

namespace fumage {

namespace {

/// Calls take(light) with the light that files of floats have.
template <class Take>
auto withBackground(const Image& image, const Output& output, const Take& take)
{
    if (output.background == Background::Transparent) {
        return take(image);
    }
    Image light = image;
    fillBackground(light, output.backgroundColour);
    return take(light);
}

template <class Channel, class Finish>
Result<std::vector<std::byte>> encodePngOf(const Image& image, const Scene& scene, const ImageMetadata& notes,
    const std::stop_token& stop, const Finish& finish)
{
    EncodedImage<Channel> encoded;
    encode(image, scene.output, encoded, coverOf(scene));
    finish(encoded);
    return encodePng({image.width, image.height, 4, static_cast<int>(8 * sizeof(Channel)), true,
                         std::as_bytes(std::span(encoded.pixels)), false, notes},
        stop);
}

template <class Finish>
Result<std::vector<std::byte>> encodeTgaOf(const Image& image, const Scene& scene, const Finish& finish)
{
    EncodedImage<std::uint8_t> encoded;
    encode(image, scene.output, encoded, coverOf(scene));
    finish(encoded);
    if (scene.output.background == Background::Transparent) {
        return encodeTga({image.width, image.height, 4, encoded.pixels});
    }
    std::vector<std::uint8_t> colours;
    colours.reserve(encoded.pixels.size() / 4 * 3);
    for (std::size_t i = 0; i < encoded.pixels.size(); i += 4) {
        colours.insert(colours.end(), {encoded.pixels[i], encoded.pixels[i + 1], encoded.pixels[i + 2]});
    }
    return encodeTga({image.width, image.height, 3, colours});
}

/// @param finish called with the encoded picture, where it holds no floats
template <class Finish>
Result<std::vector<std::byte>> encodeWith(const Image& image, const Scene& scene, ImageFormat format,
    const ImageMetadata& notes, const std::stop_token& stop, const Finish& finish)
{
    switch (format) {
    case ImageFormat::Png8: return encodePngOf<std::uint8_t>(image, scene, notes, stop, finish);
    case ImageFormat::Png16: return encodePngOf<std::uint16_t>(image, scene, notes, stop, finish);
    case ImageFormat::ExrHalf:
    case ImageFormat::ExrFloat:
        return withBackground(image, scene.output, [&](const Image& light) {
            return encodeExr({light.width, light.height, {{{}, exrChannels(4), light.pixels}},
                                 format == ImageFormat::ExrHalf, notes},
                stop);
        });
    case ImageFormat::Tga: return encodeTgaOf(image, scene, finish);
    }
    return Error{ErrorCode::WriteFailed, makeMessage("unknown image format"), {}, {}};
}

inline int steps(float value, bool isSigned, int full)
{
    const float share = std::clamp(isSigned ? 0.5F + 0.5F * value : value, 0.0F, 1.0F);
    return static_cast<int>(share * static_cast<float>(full) + 0.5F);
}

template <class Channel>
RawArray<Channel> quantisedAll(const DataImage& image)
{
    RawArray<Channel> pixels(image.values.size());
    std::transform(image.values.begin(), image.values.end(), pixels.begin(), [&](float value) {
        return static_cast<Channel>(steps(value, image.isSigned, std::numeric_limits<Channel>::max()));
    });
    return pixels;
}

template <class Channel>
Result<std::vector<std::byte>> encodeNumbers(
    const DataImage& image, const ImageMetadata& notes, const std::stop_token& stop)
{
    const RawArray<Channel> pixels = quantisedAll<Channel>(image);
    return encodePng({image.width, image.height, image.channels, static_cast<int>(8 * sizeof(Channel)), image.isSrgb,
                         std::as_bytes(std::span(pixels)), true, notes},
        stop);
}

template <class Channel>
DataImage numbersOfSheet(const Image& image, const Scene& scene, int cellWidth, int cellHeight)
{
    EncodedImage<Channel> encoded;
    encode(image, scene.output, encoded, coverOf(scene));
    bleedColours(encoded, cellWidth, cellHeight);
    DataImage out{image.width, image.height, 4, false, {}, true};
    out.values.resize(encoded.pixels.size());
    constexpr auto kFull = static_cast<float>(std::numeric_limits<Channel>::max());
    std::transform(encoded.pixels.begin(), encoded.pixels.end(), out.values.begin(),
        [](Channel value) { return static_cast<float>(value) / kFull; });
    return out;
}

} // namespace

bool holdsFloats(ImageFormat format)
{
    return format == ImageFormat::ExrHalf || format == ImageFormat::ExrFloat;
}

int fullOf(ImageFormat format)
{
    return format == ImageFormat::Png16 ? std::numeric_limits<std::uint16_t>::max()
                                        : std::numeric_limits<std::uint8_t>::max();
}

std::string_view nameOf(ImageFormat format)
{
    switch (format) {
    case ImageFormat::Png8: return "png";
    case ImageFormat::Png16: return "png16";
    case ImageFormat::ExrHalf: return "exr";
    case ImageFormat::ExrFloat: return "exr32";
    case ImageFormat::Tga: return "tga";
    }
    return {};
}

std::string_view fileEnding(ImageFormat format)
{
    return format == ImageFormat::Tga ? ".tga" : holdsFloats(format) ? ".exr" : ".png";
}

ImageFormat formatOf(const std::filesystem::path& path, bool wide)
{
    if (endingOf(path) == ".exr") {
        return wide ? ImageFormat::ExrFloat : ImageFormat::ExrHalf;
    }
    if (endingOf(path) == ".tga") {
        return ImageFormat::Tga;
    }
    return wide ? ImageFormat::Png16 : ImageFormat::Png8;
}

std::filesystem::path withEnding(const std::filesystem::path& path, std::string_view ending)
{
    return endingOf(path) == ending ? path
                                    : path.parent_path() / pathFrom(path.filename().string() + std::string(ending));
}

Result<std::vector<std::byte>> encodeImage(
    const Image& image, const Scene& scene, ImageFormat format, const ImageMetadata& notes, const std::stop_token& stop)
{
    return encodeWith(image, scene, format, notes, stop, [](auto&) {});
}

Result<std::vector<std::byte>> encodeSheet(const Image& image, const Scene& scene, ImageFormat format, int cellWidth,
    int cellHeight, const ImageMetadata& notes)
{
    return encodeWith(
        image, scene, format, notes, {}, [&](auto& encoded) { bleedColours(encoded, cellWidth, cellHeight); });
}

DataImage sheetNumbers(const Image& image, const Scene& scene, ImageFormat format, int cellWidth, int cellHeight)
{
    if (holdsFloats(format)) {
        return withBackground(image, scene.output, [](const Image& light) {
            return DataImage{light.width, light.height, 4, false, light.pixels};
        });
    }
    return format == ImageFormat::Png16 ? numbersOfSheet<std::uint16_t>(image, scene, cellWidth, cellHeight)
                                        : numbersOfSheet<std::uint8_t>(image, scene, cellWidth, cellHeight);
}

Result<std::vector<std::byte>> encodeData(
    const DataImage& image, ImageFormat format, const ImageMetadata& notes, const std::stop_token& stop)
{
    switch (format) {
    case ImageFormat::Png8: return encodeNumbers<std::uint8_t>(image, notes, stop);
    case ImageFormat::Png16: return encodeNumbers<std::uint16_t>(image, notes, stop);
    case ImageFormat::Tga:
        return encodeTga({image.width, image.height, image.channels, quantisedAll<std::uint8_t>(image)});
    case ImageFormat::ExrHalf:
    case ImageFormat::ExrFloat: break;
    }
    return encodeExr({image.width, image.height, {{{}, exrChannels(image.channels), image.values}},
                         format == ImageFormat::ExrHalf, notes, false},
        stop);
}

int quantised(float value, bool isSigned, int full)
{
    return steps(value, isSigned, full);
}

DataImage stored(DataImage image, ImageFormat format)
{
    if (!holdsFloats(format)) {
        const int full = fullOf(format);
        for (float& value : image.values) {
            const float share = static_cast<float>(quantised(value, image.isSigned, full)) / static_cast<float>(full);
            value = image.isSigned ? 2.0F * share - 1.0F : share;
        }
    }
    return image;
}

Result<std::vector<std::byte>> encodeNoise(const NoiseTile& tile, ImageFormat format)
{
    DataImage flipped{tile.size, tile.size, 1, false, {}};
    const auto size = static_cast<std::ptrdiff_t>(tile.size);
    for (std::ptrdiff_t y = size - 1; y >= 0; --y) {
        flipped.values.insert(
            flipped.values.end(), tile.values.begin() + y * size, tile.values.begin() + (y + 1) * size);
    }
    return encodeData(flipped, format);
}

} // namespace fumage
