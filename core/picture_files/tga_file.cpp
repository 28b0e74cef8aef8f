#include "core/picture_files/tga_file.h"

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
constexpr std::size_t kMostInRun = 128;
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
    [[nodiscard]] bool areSame(std::size_t a, std::size_t b) const { return std::equal(at(a), at(a) + m_channels, at(b)); }

    /// How many pixels from one on are the same, at most as many as a run holds.
    [[nodiscard]] std::size_t sameFrom(std::size_t first) const
    {
        std::size_t past = first + 1;
        while (past < size() && past - first < kMostInRun && areSame(first, past)) {
            ++past;
        }
        return past - first;
    }
    /// How many from one on differ each from the next.
    [[nodiscard]] std::size_t differentFrom(std::size_t first) const
    {
        std::size_t past = first + 1;
        while (past < size() && past - first < kMostInRun && (past + 1 == size() || !areSame(past, past + 1))) {
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

} // namespace fumage
