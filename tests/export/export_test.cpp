#include "tests/helpers.h"

#include "core/base/file.h"
#include "core/export/particle_dump.h"
#include "core/export/sequence.h"
#include "core/rendering/view_transform.h"

#include <QProcess>
#include <QTemporaryDir>

#include <png.h>

using namespace fumage;
using namespace fumage::tests;

namespace {

Image ramp()
{
    Image image;
    image.resize(40, 30);
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        const float a = static_cast<float>(i % 160) / 160.0F;
        image.pixels[i] = 0.9F * a;
        image.pixels[i + 1] = 0.3F * a;
        image.pixels[i + 2] = 0.1F * a;
        image.pixels[i + 3] = a;
    }
    return image;
}

/// The samples of a 16-bit PNG through libpng's own reader, without any conversion but the byte order.
std::vector<std::uint16_t> readPng16(const std::vector<std::byte>& bytes)
{
    struct Source {
        const std::byte* at;
    } source{bytes.data()};
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_read_fn(png, &source, [](png_structp reader, png_bytep to, png_size_t size) {
        auto* from = static_cast<Source*>(png_get_io_ptr(reader));
        std::memcpy(to, from->at, size);
        from->at += size;
    });
    png_read_png(png, info, PNG_TRANSFORM_SWAP_ENDIAN, nullptr);
    std::vector<std::uint16_t> pixels;
    for (png_uint_32 y = 0; y < png_get_image_height(png, info); ++y) {
        const auto* row = reinterpret_cast<const std::uint16_t*>(png_get_rows(png, info)[y]);
        pixels.insert(pixels.end(), row, row + png_get_image_width(png, info) * 4);
    }
    png_destroy_read_struct(&png, &info, nullptr);
    return pixels;
}

SequenceOptions options(const std::string& output, FrameRange frames)
{
    SequenceOptions out;
    out.output = output;
    out.frames = frames;
    return out;
}

} // namespace

class ExportTest : public QObject {
    Q_OBJECT

private slots:
    void png8ReadsBackThroughLibpng()
    {
        const Image image = ramp();
        const std::vector<std::byte> bytes = encodeImage(image, Output{}, ImageFormat::Png8).value();
        png_image png{};
        png.version = PNG_IMAGE_VERSION;
        QVERIFY(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) != 0);
        QCOMPARE(png.width, 40U);
        QCOMPARE(png.height, 30U);
        png.format = PNG_FORMAT_RGBA;
        std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(png));
        QVERIFY(png_image_finish_read(&png, nullptr, pixels.data(), 0, nullptr) != 0);
        EncodedImage<std::uint8_t> expected;
        encode(image, Output{}, expected);
        QVERIFY(pixels == expected.pixels);
    }

    void png16HasSixteenBits()
    {
        const std::vector<std::byte> bytes = encodeImage(ramp(), Output{}, ImageFormat::Png16).value();
        QCOMPARE(int(bytes[24]), 16); // IHDR: bit depth
        QCOMPARE(int(bytes[25]), 6); // RGBA
        EncodedImage<std::uint16_t> expected;
        encode(ramp(), Output{}, expected);
        QVERIFY(readPng16(bytes) == expected.pixels);
    }

    void exrIsWhatExrheaderSays()
    {
        const QTemporaryDir folder;
        for (const auto& [format, type] : {std::pair{ImageFormat::ExrHalf, "16-bit floating-point"}, std::pair{ImageFormat::ExrFloat, "32-bit floating-point"}}) {
            const std::string path = folder.path().toStdString() + "/a.exr";
            QVERIFY(writeFileAtomically(path, encodeImage(ramp(), Output{}, format).value()).ok());
            QProcess header;
            header.start("exrheader", {QString::fromStdString(path)});
            QVERIFY2(header.waitForFinished() && header.exitCode() == 0, "exrheader (package openexr) must be installed");
            const QString text = header.readAllStandardOutput();
            QVERIFY2(text.contains("A, " + QString(type)) && text.contains("R, " + QString(type)), qPrintable(text));
            QVERIFY(text.contains("dataWindow (type box2i): (0 0) - (39 29)"));
        }
    }

    void sameInputGivesTheSameBytes()
    {
        for (const ImageFormat format : {ImageFormat::Png8, ImageFormat::Png16, ImageFormat::ExrHalf, ImageFormat::ExrFloat}) {
            QVERIFY(encodeImage(ramp(), Output{}, format).value() == encodeImage(ramp(), Output{}, format).value());
        }
    }

    void frameRanges_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("count");
        QTest::newRow("one") << "7" << 1;
        QTest::newRow("range") << "0-119" << 120;
        QTest::newRow("step") << "0-9:4" << 3;
        QTest::newRow("spaces") << " 1 - 2 " << 2;
        for (const char* bad : {"", "a", "1-", "-1", "5-2", "0-9:0", "0-9:x", "1.5", "0-99999999999", "1-2-3"}) {
            QTest::newRow(bad) << bad << -1;
        }
    }
    void frameRanges()
    {
        QFETCH(QString, text);
        QFETCH(int, count);
        const Result<FrameRange> range = parseFrameRange(text.toStdString());
        QCOMPARE(range.ok() ? range.value().count() : -1, count);
    }

    void framesAreNumbered()
    {
        QCOMPARE(framePath(options("out/a_####.png", {0, 9, 1}), 7), std::filesystem::path("out/a_0007.png"));
        QCOMPARE(framePath(options("out/a_##", {0, 9, 1}), 123), std::filesystem::path("out/a_123.png"));
        QCOMPARE(framePath(options("a.png", {0, 9, 1}), 7), std::filesystem::path("a_0007.png"));
        QCOMPARE(framePath(options("a.png", {7, 7, 1}), 7), std::filesystem::path("a.png"));
    }

    void aSequenceIsWrittenAndCancelled()
    {
        const QTemporaryDir folder;
        Effect effect = everythingOn();
        const SequenceOptions sequence = options(folder.path().toStdString() + "/made/here/f_###.png", {2, 8, 3});
        std::vector<int> progress;
        QVERIFY(renderSequence(effect, sequence, [&](int done, int) { progress.push_back(done); }).ok());
        QVERIFY((progress == std::vector<int>{1, 2, 3}));
        QCOMPARE(QDir(folder.path() + "/made/here").entryList(QDir::Files), QStringList({"f_002.png", "f_005.png", "f_008.png"}));
        std::stop_source stop;
        const SequenceOptions other = options(folder.path().toStdString() + "/other/g_###.png", {0, 50, 1});
        const Status status = renderSequence(
            effect, other, [&](int done, int) { if (done == 2) { stop.request_stop(); } }, stop.get_token());
        QCOMPARE(status.error().code, ErrorCode::Cancelled);
        for (const QString& name : QDir(folder.path() + "/other").entryList(QDir::Files)) {
            QVERIFY(name.endsWith(".png"));
        }
    }

    void unwritableFolderIsAnError()
    {
        const Status status = renderSequence(everythingOn(), options("/proc/none/f.png", {0, 0, 1}), [](int, int) {});
        QVERIFY(!status.ok());
        QVERIFY(status.error().text().find("/proc/none") != std::string::npos);
    }

    void dumpsHoldTheLivingParticles()
    {
        const Effect effect = everythingOn();
        const auto frame = frameOf(effect, 4);
        const int alive = livingCount(*frame);
        const QByteArray csv = QByteArray::fromStdString(dumpCsv(*frame, effect));
        QCOMPARE(csv.count('\n'), alive + 1);
        QVERIFY(csv.startsWith("id,x,y,z,vx,vy,vz,age,life,alpha,radius\n"));
        const std::string ply = dumpPly(*frame, effect);
        const std::size_t body = ply.find("end_header\n") + 11;
        QVERIFY(ply.find("element vertex " + std::to_string(alive) + "\n") != std::string::npos);
        QCOMPARE(ply.size() - body, static_cast<std::size_t>(alive) * 44);
    }
};

QTEST_GUILESS_MAIN(ExportTest)
#include "export_test.moc"
