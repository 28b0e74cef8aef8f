#include "core/effect/bitmap.h"

#include "core/image_io/png_file.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace fumage {

struct Bitmap::Data {
    int width = 0;
    int height = 0;
    std::vector<std::byte> file;
    std::vector<std::uint8_t> pixels;
    std::vector<std::uint32_t> sums; ///< of the weights up to and with each pixel; the last is 2^32 - 1 at most
    std::array<float, std::size_t{kCover} * kCover> cover{};
    float opacity = 0.0F;
};

namespace {

/// Most that a pixel weighs: of that many pixels the sum has 32 bits.
constexpr std::uint32_t kMaxWeight = 16383;
static_assert(std::uint64_t{kMaxWeight} * kMaxPictureEdge * kMaxPictureEdge < (std::uint64_t{1} << 32U));

/// Brightness times alpha of a pixel of 16 bits.
std::uint32_t weightOf(std::span<const std::uint16_t> rgba)
{
    constexpr std::uint64_t kRed = 2126; // Rec. 709, of 10000
    constexpr std::uint64_t kGreen = 7152;
    constexpr std::uint64_t kBlue = 722;
    constexpr std::uint64_t kWhite = (kRed + kGreen + kBlue) * 65535 * 65535;
    const std::uint64_t light = (kRed * rgba[0] + kGreen * rgba[1] + kBlue * rgba[2]) * rgba[3];
    return static_cast<std::uint32_t>((light * kMaxWeight + kWhite / 2) / kWhite);
}

/// Means of the pixels of each cell, over the largest.
void findCover(std::span<const std::uint32_t> weights, int width, int height, std::span<float> cover)
{
    constexpr int kCells = Bitmap::kCover;
    std::vector<double> means;
    for (int j = 0; j < kCells; ++j) {
        for (int i = 0; i < kCells; ++i) {
            const int left = i * width / kCells;
            const int top = j * height / kCells;
            const int right = std::max(left + 1, (i + 1) * width / kCells);
            const int bottom = std::max(top + 1, (j + 1) * height / kCells);
            std::uint64_t sum = 0;
            for (int y = top; y < bottom; ++y) {
                for (int x = left; x < right; ++x) {
                    sum += weights[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)
                        + static_cast<std::size_t>(x)];
                }
            }
            means.push_back(static_cast<double>(sum) / ((right - left) * (bottom - top)));
        }
    }
    const double largest = *std::max_element(means.begin(), means.end());
    std::transform(means.begin(), means.end(), cover.begin(),
        [&](double mean) { return largest > 0.0 ? static_cast<float>(mean / largest) : 0.0F; });
}

Error pictureError(ErrorCode code, Message what)
{
    return {code, std::move(what), {}, pictureRemedy()};
}

/// Looks at size and edges before anything is decoded: the picture's header is the first of a PNG.
Status check(std::span<const std::byte> png)
{
    constexpr std::size_t kWidthAt = 16;
    constexpr std::size_t kHeightAt = 20;
    constexpr std::size_t kHeaderEnd = 24;
    const std::string_view text(reinterpret_cast<const char*>(png.data()), png.size());
    if (kindOf(text) != PictureKind::Png || png.size() < kHeaderEnd) {
        return pictureError(ErrorCode::Syntax, makeMessage("this is not a PNG"));
    }
    if (png.size() > kMaxPictureBytes) {
        return pictureError(ErrorCode::TooLarge, makeMessage("a picture of %1 bytes", png.size()));
    }
    const auto edgeAt = [&](std::size_t at) {
        std::uint32_t edge = 0;
        for (std::size_t i = at; i < at + 4; ++i) {
            edge = edge << 8U | std::to_integer<std::uint32_t>(png[i]);
        }
        return edge;
    };
    const std::uint32_t width = edgeAt(kWidthAt);
    const std::uint32_t height = edgeAt(kHeightAt);
    if (width > kMaxPictureEdge || height > kMaxPictureEdge) {
        return pictureError(ErrorCode::TooLarge, makeMessage("a picture of %1 x %2 pixels", width, height));
    }
    return Done{};
}

} // namespace

Message pictureRemedy()
{
    return makeMessage("Choose a PNG of at most %1 pixels an edge and %2 bytes", kMaxPictureEdge, kMaxPictureBytes);
}

Result<Bitmap> Bitmap::read(std::span<const std::byte> png)
{
    if (const Status status = check(png); !status) {
        return status.error();
    }
    const Result<RgbaPixels> read = readPng(png);
    if (!read) {
        return pictureError(read.error().code, read.error().message);
    }
    const RgbaPixels& rgba = read.value();
    auto data = std::make_shared<Data>();
    data->width = rgba.width;
    data->height = rgba.height;
    data->file.assign(png.begin(), png.end());
    std::vector<std::uint32_t> weights;
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < rgba.values.size(); i += 4) {
        weights.push_back(weightOf(std::span(rgba.values).subspan(i, 4)));
        sum += weights.back();
        data->sums.push_back(sum);
    }
    std::transform(rgba.values.begin(), rgba.values.end(), std::back_inserter(data->pixels), [](std::uint16_t value) {
        constexpr std::uint32_t kStep = 257; // of 8 bits in 16
        return static_cast<std::uint8_t>((value + kStep / 2) / kStep);
    });
    std::uint64_t alpha = 0;
    for (std::size_t i = 3; i < data->pixels.size(); i += 4) {
        alpha += data->pixels[i];
    }
    const auto edge = static_cast<double>(std::max(data->width, data->height));
    data->opacity = static_cast<float>(static_cast<double>(alpha) / (255.0 * edge * edge));
    findCover(weights, data->width, data->height, data->cover);
    Bitmap picture;
    picture.m_data = std::move(data);
    return picture;
}

int Bitmap::width() const
{
    return empty() ? 0 : m_data->width;
}

int Bitmap::height() const
{
    return empty() ? 0 : m_data->height;
}

std::span<const std::uint8_t> Bitmap::pixels() const
{
    return empty() ? std::span<const std::uint8_t>() : m_data->pixels;
}

std::span<const std::byte> Bitmap::file() const
{
    return empty() ? std::span<const std::byte>() : m_data->file;
}

float Bitmap::opacity() const
{
    return empty() ? 0.0F : m_data->opacity;
}

bool Bitmap::isBright() const
{
    return !empty() && m_data->sums.back() > 0;
}

std::size_t Bitmap::brightPixel(std::uint32_t bits) const
{
    const std::vector<std::uint32_t>& sums = m_data->sums;
    const auto wanted = static_cast<std::uint32_t>((std::uint64_t{bits} * sums.back()) >> 32U);
    return static_cast<std::size_t>(std::upper_bound(sums.begin(), sums.end(), wanted) - sums.begin());
}

float Bitmap::coverAt(float across, float down) const
{
    const auto inCells = [](float share) {
        return std::clamp(share * kCover - 0.5F, 0.0F, static_cast<float>(kCover - 1));
    };
    const float x = inCells(across);
    const float y = inCells(down);
    const int left = std::min(static_cast<int>(x), kCover - 2);
    const int top = std::min(static_cast<int>(y), kCover - 2);
    const float right = x - static_cast<float>(left);
    const auto inRow = [&](int row) {
        const auto* at = m_data->cover.data() + static_cast<std::size_t>(row * kCover + left);
        return at[0] + right * (at[1] - at[0]);
    };
    const float upper = inRow(top);
    return upper + (y - static_cast<float>(top)) * (inRow(top + 1) - upper);
}

bool operator==(const Bitmap& a, const Bitmap& b)
{
    return a.m_data == b.m_data || std::ranges::equal(a.file(), b.file());
}

} // namespace fumage
