#include "core/image_io/tga_file.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string_view>

namespace fumage {

namespace {

constexpr std::uint8_t kGrey = 3;
constexpr std::uint8_t kColourInRuns = 10;
constexpr std::uint8_t kFromTheTop = 0x20;
constexpr std::uint8_t kRepeated = 0x80;
constexpr std::size_t kMaxInRun = 128;
constexpr std::string_view kSignature("TRUEVISION-XFILE.\0", 18);

void append(std::vector<std::byte>& out, std::initializer_list<int> bytes)
{
    for (const int byte : bytes) {
        out.push_back(static_cast<std::byte>(byte));
    }
}

void appendHeader(std::vector<std::byte>& out, const TgaPixels& pixels)
{
    constexpr int kBitsAByte = 8;
    const int type = pixels.channels == 1 ? kGrey : kColourInRuns;
    const int alphaBits = pixels.channels == 4 ? kBitsAByte : 0;
    append(out, {0, 0, type, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    append(out, {pixels.width & 255, pixels.width >> kBitsAByte, pixels.height & 255, pixels.height >> kBitsAByte});
    append(out, {pixels.channels * kBitsAByte, kFromTheTop | alphaBits});
}

/// One row of colours.
class Row {
public:
    Row(std::span<const std::uint8_t> bytes, std::size_t channels)
        : m_bytes(bytes)
        , m_channels(channels)
    {
    }

    [[nodiscard]] std::size_t size() const { return m_bytes.size() / m_channels; }
    [[nodiscard]] bool areSame(std::size_t a, std::size_t b) const
    {
        return std::equal(at(a), at(a) + m_channels, at(b));
    }

    /// How many pixels from one on are the same, at most as many as a run holds.
    [[nodiscard]] std::size_t sameFrom(std::size_t first) const
    {
        std::size_t past = first + 1;
        while (past < size() && past - first < kMaxInRun && areSame(first, past)) {
            ++past;
        }
        return past - first;
    }
    /// How many from one on differ each from the next.
    [[nodiscard]] std::size_t differentFrom(std::size_t first) const
    {
        std::size_t past = first + 1;
        while (past < size() && past - first < kMaxInRun && (past + 1 == size() || !areSame(past, past + 1))) {
            ++past;
        }
        return past - first;
    }
    void appendPixel(std::vector<std::byte>& out, std::size_t pixel) const
    {
        static constexpr std::array<std::size_t, 4> kOrder{2, 1, 0, 3};
        for (std::size_t i = 0; i < m_channels; ++i) {
            out.push_back(static_cast<std::byte>(at(pixel)[kOrder[i]]));
        }
    }

private:
    [[nodiscard]] const std::uint8_t* at(std::size_t pixel) const { return m_bytes.data() + pixel * m_channels; }

    std::span<const std::uint8_t> m_bytes;
    std::size_t m_channels;
};

void appendRuns(std::vector<std::byte>& out, const Row& row)
{
    for (std::size_t x = 0; x < row.size();) {
        const std::size_t same = row.sameFrom(x);
        const std::size_t count = same > 1 ? same : row.differentFrom(x);
        out.push_back(static_cast<std::byte>((count - 1) | (same > 1 ? kRepeated : 0U)));
        for (std::size_t i = 0; i < (same > 1 ? 1 : count); ++i) {
            row.appendPixel(out, x + i);
        }
        x += count;
    }
}

/// Hands out the bytes of a file, as long as there are any.
class ByteReader {
public:
    explicit ByteReader(std::span<const std::byte> bytes)
        : m_bytes(bytes)
    {
    }

    [[nodiscard]] bool has(std::size_t count) const { return m_bytes.size() >= count; }
    /// @param count at most as many as there are
    std::span<const std::byte> take(std::size_t count)
    {
        const auto taken = m_bytes.first(count);
        m_bytes = m_bytes.subspan(count);
        return taken;
    }
    [[nodiscard]] std::span<const std::byte> rest() const { return m_bytes; }

private:
    std::span<const std::byte> m_bytes;
};

/// BGRA, BGR or grey of 8 bits as RGBA of 16.
void appendRgba(std::vector<std::uint16_t>& out, std::span<const std::byte> pixel)
{
    constexpr int kWide = 257;
    const auto at = [&](std::size_t i) { return static_cast<std::uint16_t>(std::to_integer<int>(pixel[i]) * kWide); };
    const bool grey = pixel.size() == 1;
    out.insert(
        out.end(), {at(grey ? 0 : 2), at(grey ? 0 : 1), at(0), pixel.size() == 4 ? at(3) : std::uint16_t{0xffff}});
}

/// @return whether the bytes say what all pixels are
bool readRuns(ByteReader& bytes, std::size_t channels, std::size_t count, std::vector<std::uint16_t>& out)
{
    while (out.size() < 4 * count) {
        if (!bytes.has(1)) {
            return false;
        }
        const auto head = std::to_integer<unsigned>(bytes.take(1)[0]);
        const std::size_t length = (head & (kMaxInRun - 1)) + 1;
        const bool repeated = (head & kRepeated) != 0;
        if (length > count - out.size() / 4 || !bytes.has(channels * (repeated ? 1 : length))) {
            return false;
        }
        std::span<const std::byte> pixel;
        for (std::size_t i = 0; i < length; ++i) {
            pixel = repeated && i > 0 ? pixel : bytes.take(channels);
            appendRgba(out, pixel);
        }
    }
    return true;
}

bool readPlain(ByteReader& bytes, std::size_t channels, std::size_t count, std::vector<std::uint16_t>& out)
{
    if (!bytes.has(count * channels)) {
        return false;
    }
    for (std::size_t i = 0; i < count; ++i) {
        appendRgba(out, bytes.take(channels));
    }
    return true;
}

constexpr std::size_t kHeaderBytes = 18;
constexpr std::size_t kFooterBytes = 8 + kSignature.size();

} // namespace

std::vector<std::byte> encodeTga(const TgaPixels& pixels)
{
    const auto channels = static_cast<std::size_t>(pixels.channels);
    const std::size_t rowBytes = static_cast<std::size_t>(pixels.width) * channels;
    assert(pixels.width > 0 && pixels.width < 65536 && pixels.height > 0 && pixels.height < 65536);
    assert(pixels.bytes.size() == rowBytes * static_cast<std::size_t>(pixels.height));
    std::vector<std::byte> out;
    appendHeader(out, pixels);
    if (pixels.channels == 1) {
        const auto grey = std::as_bytes(pixels.bytes);
        out.insert(out.end(), grey.begin(), grey.end());
    } else {
        for (std::size_t at = 0; at < pixels.bytes.size(); at += rowBytes) {
            appendRuns(out, Row(pixels.bytes.subspan(at, rowBytes), channels));
        }
    }
    append(out, {0, 0, 0, 0, 0, 0, 0, 0});
    const auto signature = std::as_bytes(std::span(kSignature));
    out.insert(out.end(), signature.begin(), signature.end());
    return out;
}

Result<RgbaPixels> readTga(std::span<const std::byte> file)
{
    const Error broken{ErrorCode::Syntax,
        makeMessage("the picture is broken: %1", makeMessage("it is no TGA that Fumage has written, or not whole")), {},
        {}};
    ByteReader bytes(file);
    if (!bytes.has(kHeaderBytes)) {
        return broken;
    }
    const std::span<const std::byte> header = bytes.take(kHeaderBytes);
    const auto at = [&](std::size_t i) { return std::to_integer<int>(header[i]); };
    RgbaPixels pixels{at(12) + 256 * at(13), at(14) + 256 * at(15), {}};
    const std::size_t count = static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height);
    const auto channels = static_cast<std::size_t>(at(16) / 8);
    const bool known = at(2) == kGrey ? channels == 1 : at(2) == kColourInRuns && (channels == 3 || channels == 4);
    if (!known || (at(17) & kFromTheTop) == 0 || count == 0) {
        return broken;
    }
    if (count > kMaxReadPixels) {
        return Error{
            ErrorCode::TooLarge, makeMessage("a picture of %1 x %2 pixels", pixels.width, pixels.height), {}, {}};
    }
    pixels.values.reserve(
        std::min(count, file.size() * kMaxInRun) * 4); // a short file that says it is large gets no memory
    const bool read = at(2) == kGrey ? readPlain(bytes, channels, count, pixels.values)
                                     : readRuns(bytes, channels, count, pixels.values);
    const bool ends = bytes.rest().size() == kFooterBytes
        && std::ranges::equal(bytes.rest().last(kSignature.size()), std::as_bytes(std::span(kSignature)));
    return read && ends ? Result<RgbaPixels>(std::move(pixels)) : broken;
}

} // namespace fumage
