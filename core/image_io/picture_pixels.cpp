#include "core/image_io/picture_pixels.h"

#include "core/base/sha256.h"
#include "core/image_io/exr_file.h"
#include "core/image_io/image_metadata.h"
#include "core/image_io/png_file.h"
#include "core/image_io/tga_file.h"

#include <bit>
#include <optional>
#include <string>

namespace fumage {

namespace {

std::string_view textOf(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Adds numbers with the low byte first.
template <class Word, class Number>
void addNumbers(Sha256& hash, std::span<const Number> numbers)
{
    static_assert(sizeof(Word) == sizeof(Number));
    if constexpr (std::endian::native == std::endian::little) {
        hash.add(std::as_bytes(numbers));
        return;
    }
    for (const Number number : numbers) {
        const auto word = std::bit_cast<Word>(number);
        for (unsigned shift = 0; shift < 8 * sizeof(Word); shift += 8) {
            const auto byte = static_cast<std::byte>(word >> shift);
            hash.add(std::span(&byte, 1));
        }
    }
}

std::string headOf(const char* kind, int width, int height)
{
    return std::string(kind) + " " + std::to_string(width) + " " + std::to_string(height) + "\n";
}

/// A hash that is told the size first.
struct SizedHash {
    const char* kind;
    PictureHash picture{};
    Sha256 sum{};

    void begin(int width, int height)
    {
        picture.width = width;
        picture.height = height;
        sum.add(headOf(kind, width, height));
    }
    [[nodiscard]] Result<PictureHash> after(const Status& status)
    {
        picture.hash = sum.finish();
        return status ? Result<PictureHash>(picture) : status.error();
    }
};

constexpr const char* kRgba = "rgba16";

Result<PictureHash> exrHash(const PartReader& file)
{
    SizedHash hash{"exr"};
    std::optional<std::string> last;
    const auto add = [&](const std::string& channel, std::span<const float> part) {
        if (last != channel) {
            hash.sum.add(channel + "\n");
            last = channel;
        }
        addNumbers<std::uint32_t>(hash.sum, part);
    };
    return hash.after(readExrParts(
        file, [&](int width, int height) { hash.begin(width, height); }, add));
}

Result<PictureHash> pngHash(const PartReader& file)
{
    SizedHash hash{kRgba};
    const auto add = [&](std::span<const std::uint16_t> row) { addNumbers<std::uint16_t>(hash.sum, row); };
    return hash.after(readPngRows(
        file, [&](int width, int height) { hash.begin(width, height); }, add));
}

/// A TGA is read whole: no more of it than its largest picture takes.
Result<PictureHash> tgaHash(const PartReader& file)
{
    constexpr std::size_t kMaxBytes = kMaxReadPixels * 5; // of a run of one pixel
    const Result<std::string> text = file(0, kMaxBytes);
    if (!text) {
        return text.error();
    }
    const Result<RgbaPixels> pixels = readTga(std::as_bytes(std::span(text.value())));
    if (!pixels) {
        return pixels.error();
    }
    SizedHash hash{kRgba};
    hash.begin(pixels.value().width, pixels.value().height);
    addNumbers<std::uint16_t>(hash.sum, std::span<const std::uint16_t>(pixels.value().values));
    return hash.after(Done{});
}

} // namespace

Result<RgbaPixels> readPixels(std::span<const std::byte> file)
{
    switch (kindOf(textOf(file))) {
    case PictureKind::Png: return readPng(file);
    case PictureKind::Tga: return readTga(file);
    case PictureKind::Exr:
    case PictureKind::None: break;
    }
    return Error{ErrorCode::Syntax, makeMessage("this is neither a PNG nor a TGA"), {}, {}};
}

Result<PictureHash> pictureHash(const PartReader& file)
{
    constexpr std::size_t kSignatureBytes = 8;
    const Result<std::string> head = file(0, kSignatureBytes);
    if (!head) {
        return head.error();
    }
    switch (kindOf(head.value())) {
    case PictureKind::Png: return pngHash(file);
    case PictureKind::Exr: return exrHash(file);
    case PictureKind::Tga: return tgaHash(file);
    case PictureKind::None: break;
    }
    return Error{ErrorCode::Syntax, makeMessage("this is neither a PNG nor a TGA nor an EXR"), {}, {}};
}

Result<PictureHash> pictureHash(std::span<const std::byte> file)
{
    return pictureHash(partsOf(textOf(file)));
}

} // namespace fumage
