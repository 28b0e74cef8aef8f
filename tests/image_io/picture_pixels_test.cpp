// What a picture shows comes back from its file, and its hash does not see how it was written.

#include "core/export/image_file.h"
#include "core/image_io/exr_file.h"
#include "core/image_io/picture_pixels.h"
#include "core/image_io/png_file.h"
#include "core/image_io/tga_file.h"

#include <array>

#include <png.h>

#include <QtTest/QtTest>

using namespace fumage;

namespace {

constexpr int kWidth = 7;
constexpr int kHeight = 5;

/// Bytes that differ from pixel to pixel, with some that repeat.
std::vector<std::uint8_t> someBytes(int channels)
{
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < kWidth * kHeight * channels; ++i) {
        bytes.push_back(static_cast<std::uint8_t>(i / channels % 3 == 0 ? 9 : i * 37));
    }
    return bytes;
}

std::vector<std::byte> png(
    const std::vector<std::uint8_t>& bytes, int channels, bool quick = false, const std::string& preset = {})
{
    return encodePng({kWidth, kHeight, channels, 8, true, std::as_bytes(std::span(bytes)), quick, {0, preset, 3}})
        .value();
}

std::vector<std::byte> exr(bool half, std::span<const float> values, const std::string& target = {})
{
    ExrPixels pixels{2, 2, {{target, "RGBA", values}}, half};
    return encodeExr(pixels).value();
}

std::string hashOf(const std::vector<std::byte>& file)
{
    const Result<PictureHash> hash = pictureHash(file);
    return hash ? hash.value().hash : hash.error().text();
}

/// As another program writes it: interlaced, packed as well as can be.
std::vector<std::byte> interlacedPng(const std::vector<std::uint8_t>& bytes)
{
    std::vector<std::byte> file;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &file,
        [](png_structp from, png_bytep data, png_size_t size) {
            auto* to = static_cast<std::vector<std::byte>*>(png_get_io_ptr(from));
            const auto* first = reinterpret_cast<const std::byte*>(data);
            to->insert(to->end(), first, first + size);
        },
        nullptr);
    png_set_compression_level(png, 9);
    png_set_IHDR(png, info, kWidth, kHeight, 8, PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_ADAM7,
        PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    std::vector<png_bytep> rows;
    for (int y = 0; y < kHeight; ++y) {
        rows.push_back(const_cast<png_bytep>(bytes.data()) + y * kWidth * 4);
    }
    png_set_rows(png, info, rows.data());
    png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    png_destroy_write_struct(&png, &info);
    return file;
}

} // namespace

class PicturePixelsTest : public QObject {
    Q_OBJECT

private slots:
    void pixelsComeBack_data()
    {
        QTest::addColumn<int>("channels");
        QTest::newRow("grey") << 1;
        QTest::newRow("RGB") << 3;
        QTest::newRow("RGBA") << 4;
    }
    void pixelsComeBack()
    {
        QFETCH(int, channels);
        const std::vector<std::uint8_t> bytes = someBytes(channels);
        const std::vector<std::byte> tga = encodeTga({kWidth, kHeight, channels, bytes});
        for (const std::vector<std::byte>& file : {png(bytes, channels), tga}) {
            const Result<RgbaPixels> pixels = readPixels(file);
            QVERIFY2(pixels.ok(), pixels ? "" : pixels.error().text().c_str());
            QCOMPARE(pixels.value().width, kWidth);
            QCOMPARE(pixels.value().height, kHeight);
            for (std::size_t i = 0; i < std::size_t{kWidth} * kHeight; ++i) {
                const auto at = [&](std::size_t channel) {
                    return bytes[i * static_cast<std::size_t>(channels) + channel] * 257;
                };
                const std::array<int, 4> expected{
                    at(0), at(channels == 1 ? 0 : 1), at(channels == 1 ? 0 : 2), channels == 4 ? at(3) : 65535};
                for (std::size_t channel = 0; channel < 4; ++channel) {
                    QCOMPARE(int{pixels.value().values[4 * i + channel]}, expected[channel]);
                }
            }
        }
        QCOMPARE(hashOf(tga), hashOf(png(bytes, channels)));
    }

    void wideNumbersKeepAllBits()
    {
        const std::vector<std::uint16_t> wide{0, 1, 257, 65535, 258, 30000, 65534, 7};
        const std::vector<std::byte> file = encodePng({2, 1, 4, 16, true, std::as_bytes(std::span(wide))}).value();
        QVERIFY(readPixels(file).value().values == wide);
    }

    void compressionAndNotesDoNotMatter()
    {
        const std::vector<std::uint8_t> bytes = someBytes(4);
        const std::vector<std::byte> plain = png(bytes, 4);
        const std::vector<std::byte> quick = png(bytes, 4, true, "{\"a\": 1}");
        QVERIFY(plain != quick);
        QCOMPARE(hashOf(quick), hashOf(plain));
        // Another program writes it anew.
        QVERIFY(interlacedPng(bytes) != plain);
        QCOMPARE(hashOf(interlacedPng(bytes)), hashOf(plain));
    }

    void onePixelMatters()
    {
        std::vector<std::uint8_t> bytes = someBytes(4);
        const std::string before = hashOf(png(bytes, 4));
        bytes.back() ^= 1U;
        QVERIFY(hashOf(png(bytes, 4)) != before);
    }

    void halfAndFloatOfTheSameNumbersAreTheSame()
    {
        const std::array<float, 16> values{
            0.0F, 0.5F, 1.0F, 2.0F, 0.25F, -1.0F, 1024.0F, 0.125F, 3.0F, 0.0F, 0.0F, 0.0F, 1.0F, 1.0F, 1.0F, 1.0F};
        QCOMPARE(hashOf(exr(true, values)), hashOf(exr(false, values)));
        QVERIFY(hashOf(exr(false, values, "motion")) != hashOf(exr(false, values)));
        const ExrNumbers numbers = readExr(exr(true, values)).value();
        QCOMPARE(numbers.channels.size(), std::size_t{4});
        QCOMPARE(numbers.channels[3].name, std::string("R")); // by name: A, B, G, R
        QCOMPARE(numbers.channels[3].values[1], 0.25F);
    }

    void whatIsNotWholeIsNoPicture()
    {
        const std::array<float, 16> values{};
        const std::vector<std::uint8_t> bytes = someBytes(4);
        for (const std::vector<std::byte>& file :
            {png(bytes, 4), encodeTga({kWidth, kHeight, 4, bytes}), exr(true, values)}) {
            QVERIFY(pictureHash(file).ok());
            for (std::size_t size = 0; size < file.size(); ++size) {
                QVERIFY2(!pictureHash(std::span(file).first(size)).ok(), std::to_string(size).c_str());
            }
        }
    }

    void pixelsThatWereHurtAreNoticed()
    {
        std::vector<std::byte> file = png(someBytes(4), 4);
        file[file.size() - 24] ^= std::byte{1}; // the checksum of the pixels, or they themselves
        QVERIFY(!pictureHash(file).ok());
    }

    void hugeSizesGetNoMemory()
    {
        std::vector<std::byte> tga = encodeTga({kWidth, kHeight, 4, someBytes(4)});
        tga[12] = tga[13] = tga[14] = tga[15] = std::byte{0xff};
        QVERIFY(pictureHash(tga).error().code == ErrorCode::TooLarge);
        const std::vector<std::uint8_t> row(60000, 0);
        std::vector<std::byte> wide = encodePng({60000, 1, 1, 8, true, std::as_bytes(std::span(row))}).value();
        QVERIFY(pictureHash(wide).ok());
    }
};

QTEST_GUILESS_MAIN(PicturePixelsTest)
#include "picture_pixels_test.moc"
