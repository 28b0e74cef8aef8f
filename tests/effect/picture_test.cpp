// Pictures that effects hold: read with suspicion, kept as they are, and found again in presets.

#include "tests/helpers.h"
#include "tests/pictures.h"

#include "core/base/base64.h"
#include "core/effect/assignment.h"
#include "core/effect/known_parameter.h"
#include "core/effect/value.h"
#include "core/preset/picture_file.h"
#include "core/preset/preset_file.h"

#include <fstream>

#include <QTemporaryDir>

using namespace fumage;
using namespace fumage::tests;

namespace {

using Rgba = std::array<std::uint8_t, 4>;

/// Two pixels of one row.
Bitmap twoPixels(const Rgba& left, const Rgba& right)
{
    return pictureOf(2, 1, [&](int x, int /*y*/) { return x == 0 ? left : right; });
}

/// How often the left of two pixels is found, over all random numbers as far as their upper 20 bits tell them apart.
double shareOfLeft(const Bitmap& picture)
{
    constexpr std::uint32_t kNumbers = 1U << 20U;
    std::uint32_t left = 0;
    for (std::uint32_t i = 0; i < kNumbers; ++i) {
        left += picture.brightPixel(i << 12U) == 0 ? 1 : 0;
    }
    return static_cast<double>(left) / kNumbers;
}

Preset presetWith(const Bitmap& picture)
{
    Preset preset;
    preset.name = "Logo";
    preset.scene.layers.front().name = "Burning logo";
    preset.scene.layers.front().emitter.shape = EmitterShape::Picture;
    preset.scene.layers.front().emitter.picture = picture;
    return preset;
}

} // namespace

class PictureTest : public QObject {
    Q_OBJECT

private slots:
    void pixelsAreThoseThatWereWritten()
    {
        const auto colour = [](int x, int y) {
            return Rgba{static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), static_cast<std::uint8_t>(x * y),
                static_cast<std::uint8_t>(255 - x)};
        };
        const Bitmap picture = pictureOf(17, 5, colour);
        QCOMPARE(picture.width(), 17);
        QCOMPARE(picture.height(), 5);
        for (int y = 0; y < 5; ++y) {
            for (int x = 0; x < 17; ++x) {
                for (std::size_t channel = 0; channel < 4; ++channel) {
                    QCOMPARE(
                        picture.pixels()[static_cast<std::size_t>(4 * (17 * y + x)) + channel], colour(x, y)[channel]);
                }
            }
        }
        const std::vector<std::byte> file = pngOf(17, 5, colour);
        QVERIFY(std::ranges::equal(picture.file(), file));
    }

    void picturesAreTheSameWhereTheirFilesAre()
    {
        const Bitmap picture = ramp(8, 8);
        const Bitmap copy = picture; // NOLINT(performance-unnecessary-copy-initialization)
        QVERIFY(picture == copy && picture == ramp(8, 8));
        QVERIFY(!(picture == ramp(8, 9)) && !(picture == Bitmap()) && Bitmap() == Bitmap());
        QVERIFY(Bitmap().empty() && !Bitmap().isBright() && Bitmap().width() == 0 && Bitmap().pixels().empty());
    }

    void aPixelIsFoundAsOftenAsItIsBrightAndOpaque_data()
    {
        QTest::addColumn<Bitmap>("picture");
        QTest::addColumn<double>("share");
        const Rgba white{255, 255, 255, 255};
        QTest::newRow("both white") << twoPixels(white, white) << 0.5;
        QTest::newRow("grey") << twoPixels({51, 51, 51, 255}, white) << 0.2 / 1.2;
        QTest::newRow("half transparent") << twoPixels({255, 255, 255, 51}, white) << 0.2 / 1.2;
        QTest::newRow("red and green") << twoPixels({255, 0, 0, 255}, {0, 255, 0, 255}) << 0.2126 / (0.2126 + 0.7152);
        QTest::newRow("blue and green") << twoPixels({0, 0, 255, 255}, {0, 255, 0, 255}) << 0.0722 / (0.0722 + 0.7152);
        QTest::newRow("black") << twoPixels({0, 0, 0, 255}, white) << 0.0;
        QTest::newRow("transparent") << twoPixels({255, 255, 255, 0}, {1, 1, 1, 255}) << 0.0;
        QTest::newRow("the other one black") << twoPixels(white, {0, 0, 0, 255}) << 1.0;
    }
    void aPixelIsFoundAsOftenAsItIsBrightAndOpaque()
    {
        QFETCH(Bitmap, picture);
        QFETCH(double, share);
        QVERIFY(picture.isBright());
        // weights are whole numbers of 16383
        const double tolerance = share == 0.0 || share == 1.0 ? 0.0 : 1e-4;
        QVERIFY(near(shareOfLeft(picture), share, tolerance));
    }

    void whatIsDarkThroughoutIsNotBright() { QVERIFY(!twoPixels({0, 0, 0, 255}, {255, 255, 255, 0}).isBright()); }

    void theLastRandomNumberFindsTheLastPixelThatIsBright()
    {
        const Bitmap white = pictureOf(kMaxPictureEdge, kMaxPictureEdge, [](int, int) {
            return Rgba{255, 255, 255, 255};
        });
        QCOMPARE(white.brightPixel(0), std::size_t{0});
        QCOMPARE(white.brightPixel(~0U), std::size_t{kMaxPictureEdge} * kMaxPictureEdge - 1);
        const Bitmap half = twoPixels({255, 255, 255, 255}, {0, 0, 0, 255});
        QCOMPARE(half.brightPixel(~0U), std::size_t{0});
    }

    void coverIsOneWhereItIsBrightestAndNothingWhereItIsDark()
    {
        const Bitmap half = pictureOf(64, 64, [](int x, int /*y*/) {
            const auto grey = static_cast<std::uint8_t>(x < 32 ? 0 : 100);
            return Rgba{grey, grey, grey, 255};
        });
        QCOMPARE(half.coverAt(0.25F, 0.5F), 0.0F);
        QCOMPARE(half.coverAt(0.75F, 0.5F), 1.0F);
        QCOMPARE(half.coverAt(0.5F, 0.5F), 0.5F);
        QCOMPARE(half.coverAt(-3.0F, 9.0F), 0.0F);
        QCOMPARE(half.coverAt(3.0F, -9.0F), 1.0F);
        const Bitmap one = pictureOf(1, 1, [](int, int) { return Rgba{9, 9, 9, 9}; });
        QCOMPARE(one.coverAt(0.1F, 0.9F), 1.0F);
    }

    // --- what anybody may have made ---------------------------------------------------------------------------------

    void aFileThatIsCutOffIsRefusedWithWhatToDo()
    {
        const std::vector<std::byte> file = pngOf(5, 4, [](int x, int y) {
            return Rgba{static_cast<std::uint8_t>(40 * x), static_cast<std::uint8_t>(50 * y), 7, 255};
        });
        for (std::size_t length = 0; length < file.size(); ++length) {
            const Result<Bitmap> picture = Bitmap::read(std::span(file).first(length));
            QVERIFY2(!picture, qPrintable(QString::number(length)));
            QVERIFY(picture.error().text().find("at most 512 pixels an edge") != std::string::npos);
        }
        QVERIFY(Bitmap::read(file).ok());
    }

    void aFileWithAByteThatIsAnotherIsReadOrRefused()
    {
        const std::vector<std::byte> file = pngOf(5, 4, [](int, int) { return Rgba{1, 2, 3, 4}; });
        for (std::size_t at = 0; at < file.size(); ++at) {
            for (const unsigned flip : {1U, 128U, 255U}) {
                std::vector<std::byte> other = file;
                other[at] ^= static_cast<std::byte>(flip);
                const Result<Bitmap> picture = Bitmap::read(other);
                QVERIFY(!picture || (picture.value().width() == 5 && picture.value().height() == 4));
            }
        }
    }

    void picturesThatAreTooLargeAreRefusedBeforeTheyAreDecoded()
    {
        std::vector<std::byte> huge = pngOf(4, 4, [](int, int) { return Rgba{}; });
        for (std::size_t at = 16; at < 24; ++at) {
            huge[at] = std::byte{0x3f}; // both edges; the checksum is wrong, too, but nobody looks
        }
        QCOMPARE(Bitmap::read(huge).error().code, ErrorCode::TooLarge);
        QCOMPARE(Bitmap::read(pngOf(513, 1, [](int, int) { return Rgba{}; })).error().code, ErrorCode::TooLarge);
        QVERIFY(Bitmap::read(pngOf(512, 1, [](int, int) { return Rgba{}; })).ok());
        std::vector<std::byte> long_ = pngOf(4, 4, [](int, int) { return Rgba{}; });
        long_.resize(kMaxPictureBytes + 1);
        QCOMPARE(Bitmap::read(long_).error().code, ErrorCode::TooLarge);
        QCOMPARE(Bitmap::read({}).error().code, ErrorCode::Syntax);
    }

    // --- as values of parameters ------------------------------------------------------------------------------------

    void textAndValueAreTheSame()
    {
        const Parameter& row = knownParameter("emitter.picture");
        const Value value = ramp(6, 3);
        const std::string text = formatText(row, value);
        QVERIFY(parseValue(row, text).value().value == value);
        QCOMPARE(formatText(row, value, true), std::string("6 x 3 px"));
        QCOMPARE(formatText(row, Bitmap(), true), std::string("none"));
        QVERIFY(std::get<Bitmap>(parseValue(row, "").value().value).empty());
        QCOMPARE(
            parseValue(row, std::string(base64Length(kMaxPictureBytes) + 4, 'A')).error().code, ErrorCode::TooLarge);
        QCOMPARE(parseValue(row, "logo.png").error().code, ErrorCode::WrongType);
        QCOMPARE(parseValue(row, "Zm9v").error().code, ErrorCode::Syntax);
    }

    void aSettingMayNameAFile()
    {
        const QTemporaryDir folder;
        const std::string path = folder.filePath(QStringLiteral("my logo.png")).toStdString();
        const Bitmap picture = ramp(7, 2);
        std::ofstream(path, std::ios::binary)
            .write(reinterpret_cast<const char*>(picture.file().data()),
                static_cast<std::streamsize>(picture.file().size()));
        const Result<std::string> set = withPictureRead("emitter.picture = " + path);
        QVERIFY2(set.ok(), set ? "" : set.error().text().c_str());
        Effect effect;
        QVERIFY(applyAssignment(effect, set.value()).ok());
        QVERIFY(effect.emitter.picture == picture);
        QCOMPARE(withPictureRead(set.value()).value(), set.value());
        QCOMPARE(
            withPictureRead("2/emitter.picture=" + path).value().substr(0, 20), std::string("2/emitter.picture=iV"));
        for (const char* other : {"emitter.picture=", "emitter.shape=picture", "nothing", "what=ever.png"}) {
            QCOMPARE(withPictureRead(other).value(), std::string(other));
        }
        QCOMPARE(withPictureRead("emitter.picture=" + path + "x").error().code, ErrorCode::FileNotFound);
    }

    void filesThatAreNoPicturesSayWhatWouldBe()
    {
        const QTemporaryDir folder;
        const std::string path = folder.filePath(QStringLiteral("a.png")).toStdString();
        for (const std::size_t size : {std::size_t{3}, kMaxPictureBytes + 1}) {
            std::ofstream(path, std::ios::binary) << std::string(size, 'x');
            const Result<Bitmap> picture = readPictureFile(path);
            QVERIFY(!picture);
            QVERIFY(picture.error().text().find(path) != std::string::npos);
            QVERIFY(picture.error().text().find("at most 512 pixels an edge") != std::string::npos);
        }
    }

    // --- in presets -------------------------------------------------------------------------------------------------

    void aPresetKeepsThePictureToTheByte()
    {
        const Preset preset = presetWith(ramp(20, 30));
        const std::string text = formatPreset(preset);
        const Result<PresetReading> reading = parsePreset(text);
        QVERIFY2(reading.ok(), reading ? "" : reading.error().text().c_str());
        QVERIFY(reading.value().warnings.empty());
        QVERIFY(reading.value().preset.scene == preset.scene);
        QCOMPARE(formatPreset(reading.value().preset), text);
    }

    void aPictureThatIsBrokenIsRefusedByTheNameOfItsLayer_data()
    {
        QTest::addColumn<QByteArray>("json");
        QTest::newRow("no base64") << QByteArray("\"rubbish!\"");
        QTest::newRow("no picture") << QByteArray("\"Zm9v\"");
        QTest::newRow("cut off") << QByteArray("\"iVBORw0KGgoAAAANSUhEUgAAAAUAAAAE\"");
        QTest::newRow("no text") << QByteArray("[1, 2]");
    }
    void aPictureThatIsBrokenIsRefusedByTheNameOfItsLayer()
    {
        QFETCH(QByteArray, json);
        const std::string text = "{\"format\": \"fumage-preset\", \"version\": 2, \"layers\": [{\"name\": \"Smoke\"},\n"
                                 "{\"name\": \"Burning logo\", \"emitter\": {\"picture\": "
            + json.toStdString() + "}}]}";
        const Result<PresetReading> reading = parsePreset(text, "my.json");
        QVERIFY(!reading);
        const std::string said = reading.error().text();
        for (const char* part :
            {"my.json, line 2", "layer \"Burning logo\"", "emitter.picture", "at most 512 pixels an edge"}) {
            QVERIFY2(said.find(part) != std::string::npos, said.c_str());
        }
    }

    /// What is saved can be read: a scene with as many pictures as it has room for.
    void aSceneOfManyLargePicturesIsReadAgain()
    {
        Preset preset;
        preset.scene.layers.clear();
        for (std::uint32_t i = 0; i < 16; ++i) {
            preset.scene.layers.push_back(presetWith(incompressible(250, i + 1)).scene.layers.front());
            QVERIFY(preset.scene.layers.back().emitter.picture.file().size() > kMaxPictureBytes / 2);
        }
        const std::string text = formatPreset(preset);
        QVERIFY(text.size() > 2 * kMaxPresetBytes);
        const Result<PresetReading> reading = parsePreset(text);
        QVERIFY2(reading.ok(), reading ? "" : reading.error().text().c_str());
        QVERIFY(reading.value().preset.scene == preset.scene);
    }

    void aPresetThatIsLongWithoutItsPicturesIsRefused()
    {
        const std::string head =
            "{\"format\": \"fumage-preset\", \"version\": 2, \"x\": \"" + std::string(5000, 'x') + "\"";
        QVERIFY(parsePreset(head + "}").ok());
        QCOMPARE(parsePreset(head + std::string(kMaxPresetBytes, ' ') + "}").error().code, ErrorCode::TooLarge);
        QCOMPARE(parsePreset(std::string(kMaxPresetFileBytes + 1, 'x')).error().code, ErrorCode::TooLarge);
    }

    void picturesCarryAPresetOnlyAsFarAsItIsRead()
    {
        QCOMPARE(formatCarried(presetWith(ramp(9, 9))), formatPreset(presetWith(ramp(9, 9))));
        Preset large = presetWith(incompressible(250, 1));
        for (std::uint32_t i = 2; i < 8; ++i) {
            large.scene.layers.push_back(presetWith(incompressible(250, i)).scene.layers.front());
        }
        QVERIFY(formatCarried(large).empty());
    }
};

QTEST_GUILESS_MAIN(PictureTest)
#include "picture_test.moc"
