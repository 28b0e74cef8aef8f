// TGA, held against the specification: a reader that knows nothing of the writer. tests/clients/tga.py has readers of
// others.

#include "core/image_io/metadata_reader.h"
#include "core/export/image_file.h"
#include "core/image_io/tga_file.h"
#include "core/rendering/compositor.h"
#include "core/rendering/view_transform.h"

#include <algorithm>
#include <string_view>

#include <QtTest/QtTest>

using namespace fumage;

namespace {

/// A TGA of type 3 or 10 with its first pixel at the top left, as Truevision's specification reads it.
struct Tga {
    int type = 0;
    int width = 0;
    int height = 0;
    int bits = 0;
    int descriptor = 0;
    std::vector<std::uint8_t> pixels; ///< grey, BGR or BGRA
    bool endsWithFooter = false;
    bool runsEndWithRows = true;

    explicit Tga(const std::vector<std::byte>& bytes)
        : m_bytes(bytes)
    {
        type = byte(2);
        width = byte(12) + 256 * byte(13);
        height = byte(14) + 256 * byte(15);
        bits = byte(16);
        descriptor = byte(17);
        const std::size_t size = static_cast<std::size_t>(width * height * bits / 8);
        std::size_t at = 18;
        while (pixels.size() < size) {
            at = type == 10 ? readRun(at) : readByte(at);
        }
        const std::string_view rest(reinterpret_cast<const char*>(bytes.data()) + at, bytes.size() - at);
        endsWithFooter = rest == std::string_view("\0\0\0\0\0\0\0\0TRUEVISION-XFILE.\0", 26);
    }
    [[nodiscard]] std::vector<int> at(int x, int y) const
    {
        const auto each = static_cast<std::ptrdiff_t>(bits / 8);
        const auto first = pixels.begin() + (y * width + x) * each;
        return {first, first + each};
    }

private:
    [[nodiscard]] int byte(std::size_t at) const { return std::to_integer<int>(m_bytes.at(at)); }
    std::size_t readByte(std::size_t at)
    {
        pixels.push_back(static_cast<std::uint8_t>(byte(at)));
        return at + 1;
    }
    std::size_t readRun(std::size_t at)
    {
        const int head = byte(at++);
        const int count = (head & 127) + 1;
        const std::size_t each = static_cast<std::size_t>(bits) / 8;
        const std::size_t x = pixels.size() / each % static_cast<std::size_t>(width);
        runsEndWithRows &= x + static_cast<std::size_t>(count) <= static_cast<std::size_t>(width);
        for (int i = 0; i < count; ++i) {
            for (std::size_t channel = 0; channel < each; ++channel) {
                readByte(at + channel);
            }
            at += head < 128 || i + 1 == count ? each : 0;
        }
        return at;
    }

    const std::vector<std::byte>& m_bytes;
};

/// Rows that are one colour, that never repeat, and that do both, of lengths about the longest run.
std::vector<std::uint8_t> rows(int width, int channels)
{
    std::vector<std::uint8_t> bytes;
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int channel = 0; channel < channels; ++channel) {
                const int value = y == 0 ? 7
                    : y == 1             ? x * 3 + channel * 50
                    : y == 2             ? x / 5 + channel
                                         : (x % 7 < 3 ? 9 : x) + channel;
                bytes.push_back(static_cast<std::uint8_t>(value));
            }
        }
    }
    return bytes;
}

} // namespace

class TgaTest : public QObject {
    Q_OBJECT

private slots:
    void pixelsReadBack_data()
    {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("channels");
        for (const int width : {1, 2, 127, 128, 129, 257, 300}) {
            for (const int channels : {1, 3, 4}) {
                QTest::newRow(qPrintable(QStringLiteral("%1 pixels, %2 channels").arg(width).arg(channels)))
                    << width << channels;
            }
        }
    }
    void pixelsReadBack()
    {
        QFETCH(int, width);
        QFETCH(int, channels);
        const std::vector<std::uint8_t> bytes = rows(width, channels);
        const std::vector<std::byte> file = encodeTga({width, 4, channels, bytes});
        const Tga read(file);
        QCOMPARE(read.type, channels == 1 ? 3 : 10);
        QCOMPARE(read.width, width);
        QCOMPARE(read.height, 4);
        QCOMPARE(read.bits, 8 * channels);
        QCOMPARE(read.descriptor, 0x20 + (channels == 4 ? 8 : 0)); // from the top, and how many bits are alpha
        QVERIFY(read.endsWithFooter);
        QVERIFY(read.runsEndWithRows);
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x < width; ++x) {
                const std::uint8_t* p = bytes.data() + (y * width + x) * channels;
                const std::vector<int> expected = channels == 1 ? std::vector<int>{p[0]}
                    : channels == 3                             ? std::vector<int>{p[2], p[1], p[0]}
                                                                : std::vector<int>{p[2], p[1], p[0], p[3]};
                QCOMPARE(read.at(x, y), expected);
            }
        }
    }

    void oneColourTakesFewBytes()
    {
        const std::vector<std::uint8_t> clear(std::size_t{256} * 256 * 4, 0);
        QCOMPARE(encodeTga({256, 256, 4, clear}).size(), std::size_t{18 + 256 * 2 * 5 + 26});
    }

    void coloursAreThoseOfPng_data()
    {
        QTest::addColumn<bool>("isClear");
        QTest::newRow("transparent") << true;
        QTest::newRow("on a colour") << false;
    }
    void coloursAreThoseOfPng()
    {
        QFETCH(bool, isClear);
        Effect effect;
        effect.output.background = isClear ? Background::Transparent : Background::Colour;
        Image image;
        image.resize(30, 20);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            image.pixels[i] =
                i % 4 == 3 ? 0.5F + static_cast<float>(i % 100) / 200.0F : static_cast<float>(i % 17) / 40.0F;
        }
        if (!isClear) {
            fillBackground(image, glm::vec3(0.2F, 0.4F, 0.6F));
        }
        EncodedImage<std::uint8_t> expected;
        encode(image, effect.output, expected);
        const std::vector<std::byte> file = encodeImage(image, effect, ImageFormat::Tga).value();
        const Tga read(file);
        QCOMPARE(read.bits, isClear ? 32 : 24);
        for (int y = 0; y < 20; ++y) {
            for (int x = 0; x < 30; ++x) {
                const std::uint8_t* p = expected.pixels.data() + (y * 30 + x) * 4;
                QCOMPARE(read.at(x, y),
                    isClear ? (std::vector<int>{p[2], p[1], p[0], p[3]}) : (std::vector<int>{p[2], p[1], p[0]}));
            }
        }
    }

    void numbersAreStoredAsPreviewsTakeThem()
    {
        const DataImage numbers{3, 1, 3, true, {-1.0F, 0.0F, 1.0F, 0.3F, -0.3F, 2.0F, 0.01F, -0.01F, 0.5F}};
        const std::vector<std::byte> file = encodeData(numbers, ImageFormat::Tga).value();
        const Tga read(file);
        const DataImage expected = stored(numbers, ImageFormat::Tga);
        for (int x = 0; x < 3; ++x) {
            const std::vector<int> seen = read.at(x, 0);
            for (std::size_t channel = 0; channel < 3; ++channel) {
                QCOMPARE(2.0F * static_cast<float>(seen[2 - channel]) / 255.0F - 1.0F,
                    expected.values[static_cast<std::size_t>(x) * 3 + channel]);
            }
        }
    }

    void aTgaSaysThatItCarriesNothing()
    {
        const std::vector<std::uint8_t> grey(16, 3);
        const std::vector<std::byte> file = encodeTga({4, 4, 1, grey});
        const std::string_view head(reinterpret_cast<const char*>(file.data()), file.size());
        QVERIFY(isPicture(head));
        QVERIFY(readImageMetadata(head).value().preset.empty());
    }
};

QTEST_GUILESS_MAIN(TgaTest)
#include "tga_test.moc"
