#include "core/picture_files/picture_pixels.h"

#include "core/base/sha256.h"
#include "core/picture_files/exr_file.h"
#include "core/picture_files/picture_notes.h"
#include "core/picture_files/png_file.h"
#include "core/picture_files/tga_file.h"

#include <bit>

namespace fumage {

namespace {

std::string_view textOf(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Adds numbers with the low byte first.
template <class Word, class Number>
void addNumbers(Sha256& hash, const std::vector<Number>& numbers)
{
    static_assert(sizeof(Word) == sizeof(Number));
    if constexpr (std::endian::native == std::endian::little) {
        hash.add(std::as_bytes(std::span(numbers)));
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

Result<PictureHash> exrHash(std::span<const std::byte> file)
{
    const Result<ExrNumbers> numbers = readExr(file);
    if (!numbers) {
        return numbers.error();
    }
    Sha256 hash;
    hash.add(headOf("exr", numbers.value().width, numbers.value().height));
    for (const ExrNumbers::Channel& channel : numbers.value().channels) {
        hash.add(channel.name + "\n");
        addNumbers<std::uint32_t>(hash, channel.values);
    }
    return PictureHash{numbers.value().width, numbers.value().height, hash.finish()};
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
    return Error{ErrorCode::Syntax, said("this is neither a PNG nor a TGA"), {}, {}};
}

Result<PictureHash> pictureHash(std::span<const std::byte> file)
{
    if (kindOf(textOf(file)) == PictureKind::Exr) {
        return exrHash(file);
    }
    const Result<RgbaPixels> pixels = readPixels(file);
    if (!pixels) {
        return pixels.error();
    }
    Sha256 hash;
    hash.add(headOf("rgba16", pixels.value().width, pixels.value().height));
    addNumbers<std::uint16_t>(hash, pixels.value().values);
    return PictureHash{pixels.value().width, pixels.value().height, hash.finish()};
}

} // namespace fumage
