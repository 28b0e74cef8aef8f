#pragma once

#include "core/base/aligned_array.h"
#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/noise/texture.h"
#include "core/image_io/image_metadata.h"
#include "core/rendering/image.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string_view>
#include <vector>

namespace fumage {

enum class ImageFormat {
    Png8, ///< sRGB with exposure and view transform, straight alpha
    Png16, ///< the same in 16 bits
    ExrHalf, ///< linear, premultiplied, without exposure and view transform
    ExrFloat, ///< the same in 32 bits
    Tga, ///< as PNG of 8 bits, without alpha where there is a background, and without notes
};

/// All of them, in their order.
inline constexpr std::array kAllImageFormats{
    ImageFormat::Png8, ImageFormat::Png16, ImageFormat::ExrHalf, ImageFormat::ExrFloat, ImageFormat::Tga};

/// "png", "png16", "exr", "exr32" or "tga": what command lines and manifests call it.
[[nodiscard]] std::string_view nameOf(ImageFormat format);

/// Whether a format holds floats: linear, premultiplied and with all values; else what displays show, in whole numbers.
[[nodiscard]] bool holdsFloats(ImageFormat format);
/// The largest number that a channel of a format without floats holds: 255 or 65535.
[[nodiscard]] int fullOf(ImageFormat format);

/// ".png", ".exr" or ".tga".
[[nodiscard]] std::string_view fileEnding(ImageFormat format);

/// The format that the ending of a path asks for, in small letters or capitals: half floats for .exr, TGA for .tga, PNG
/// of 8 bits for .png and all others.
/// @param wide the format with more bits of the two: floats, or 16 bits; TGA has one
[[nodiscard]] ImageFormat formatOf(const std::filesystem::path& path, bool wide = false);

/// A path with an ending, which is added if it is missing; capitals will do.
/// @param ending with its dot
[[nodiscard]] std::filesystem::path withEnding(const std::filesystem::path& path, std::string_view ending);

/// Encodes a picture into the bytes of a file; the same bytes for the same picture.
/// @param effect    for PNG and TGA its exposure and view transform; where its flames are clear, alpha covers at least
/// the light that they give
/// @error WriteFailed when the library refuses; Cancelled
[[nodiscard]] Result<std::vector<std::byte>> encodeImage(const Image& image, const Scene& scene, ImageFormat format,
    const ImageMetadata& notes = {}, const std::stop_token& stop = {});

/// The same for a picture of cells, in which no colour may seep from one to the other; see bleedColours().
[[nodiscard]] Result<std::vector<std::byte>> encodeSheet(const Image& image, const Scene& scene, ImageFormat format,
    int cellWidth, int cellHeight, const ImageMetadata& notes = {});

/// Numbers that are no light for eyes: rows from the top, channels side by side.
struct DataImage {
    int width = 0;
    int height = 0;
    int channels = 4; ///< 1, 3 or 4
    bool isSigned = false; ///< in [-1, 1], which PNG and TGA hold as (1 + value) / 2; else in [0, 1]
    RawArray<float> values;
    bool isSrgb = false; ///< its colours are light after all, as displays take it; said in PNG
};

/// The numbers that encodeSheet() writes for a picture of cells: straight sRGB in [0, 1] with colours that go on under
/// transparency; of floats the picture as it is.
[[nodiscard]] DataImage sheetNumbers(
    const Image& image, const Scene& scene, ImageFormat format, int cellWidth, int cellHeight);

/// Encodes numbers as they are: PNG without a colour space, and, as in TGA, what is out of range clipped; EXR with all
/// of them.
/// @error as encodeImage()
[[nodiscard]] Result<std::vector<std::byte>> encodeData(
    const DataImage& image, ImageFormat format, const ImageMetadata& notes = {}, const std::stop_token& stop = {});

/// The number that a channel without floats holds for a value.
/// @param full 255 or 65535
[[nodiscard]] int quantised(float value, bool isSigned, int full);

/// The numbers that a file holds: those of PNG and TGA have 8 or 16 bits.
[[nodiscard]] DataImage stored(DataImage image, ImageFormat format);

/// Encodes a tile of noise as a grey picture: PNG and TGA hold the values as they are, not as light.
[[nodiscard]] Result<std::vector<std::byte>> encodeNoise(const NoiseTile& tile, ImageFormat format);

} // namespace fumage
