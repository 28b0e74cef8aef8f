#include "tests/golden/golden_pictures.h"

#include "core/system/file.h"
#include "core/image_io/png_file.h"
#include "core/rendering/view_transform.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include <QDir>
#include <QFile>

#include <png.h>

namespace fumage::tests {

namespace {

using Picture = EncodedImage<std::uint8_t>;

std::optional<Picture> readPicture(const QString& path)
{
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(&png, path.toLocal8Bit().constData()) == 0) {
        return std::nullopt;
    }
    png.format = PNG_FORMAT_RGBA;
    Picture picture{static_cast<int>(png.width), static_cast<int>(png.height), {}};
    picture.pixels.resize(PNG_IMAGE_SIZE(png));
    if (png_image_finish_read(&png, nullptr, picture.pixels.data(), 0, nullptr) == 0) {
        return std::nullopt;
    }
    return picture;
}

bool writePicture(const Picture& picture, const QString& path)
{
    PngPixels pixels;
    pixels.width = picture.width;
    pixels.height = picture.height;
    pixels.bytes = std::as_bytes(std::span(picture.pixels));
    const Result<std::vector<std::byte>> bytes = encodePng(pixels);
    return bytes.ok() && writeFileAtomically(path.toStdString(), bytes.value()).ok();
}

/// A channel as it shows over black: the colour of a transparent pixel does not matter.
int shown(const Picture& picture, std::size_t pixel, std::size_t channel)
{
    constexpr std::size_t kAlpha = 3;
    constexpr int kOpaque = 255;
    const int value = picture.pixels[pixel * 4 + channel];
    return channel == kAlpha ? value : value * picture.pixels[pixel * 4 + kAlpha] / kOpaque;
}

PictureDifference difference(const Picture& seen, const Picture& expected, Picture& out)
{
    constexpr int kStronger = 8;
    PictureDifference result;
    out = seen;
    double sum = 0.0;
    for (std::size_t pixel = 0; pixel < seen.pixels.size() / 4; ++pixel) {
        for (std::size_t channel = 0; channel < 4; ++channel) {
            const int delta = std::abs(shown(seen, pixel, channel) - shown(expected, pixel, channel));
            result.largest = std::max(result.largest, delta);
            sum += delta;
            out.pixels[pixel * 4 + channel] =
                static_cast<std::uint8_t>(channel == 3 ? 255 : std::min(255, delta * kStronger));
        }
    }
    result.mean = sum / static_cast<double>(seen.pixels.size());
    return result;
}

Picture encoded(const Image& image, const Output& output)
{
    Picture picture;
    encode(image, output, picture);
    return picture;
}

} // namespace

QString showDifference(
    const Image& seen, const Output& output, const QString& reference, const QString& folder, const QString& name)
{
    const Picture picture = encoded(seen, output);
    const QString stem = QDir(folder).absoluteFilePath(name);
    if (!QDir().mkpath(folder) || !writePicture(picture, stem + ".png")) {
        return "the picture cannot be written to " + stem + ".png";
    }
    const std::optional<Picture> expected = readPicture(reference);
    if (!expected || expected->width != picture.width || expected->height != picture.height) {
        return "what was seen is in " + stem + ".png; there is no reference of its size";
    }
    Picture apart;
    const PictureDifference delta = difference(picture, *expected, apart);
    if (!writePicture(*expected, stem + ".expected.png") || !writePicture(apart, stem + ".difference.png")) {
        return "what was seen is in " + stem + ".png; the difference cannot be written";
    }
    return QString(
        "largest difference %1 of 255, mean %2; see %3.png, .expected.png and .difference.png (8 times as strong)")
        .arg(delta.largest)
        .arg(delta.mean, 0, 'g', 3)
        .arg(stem);
}

bool writeReference(const Image& image, const Output& output, const QString& path)
{
    const Picture picture = encoded(image, output);
    const std::optional<Picture> present = readPicture(path);
    return (present && present->width == picture.width && present->pixels == picture.pixels)
        || writePicture(picture, path);
}

} // namespace fumage::tests
