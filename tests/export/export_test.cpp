#include "core/export/sheets/cell_frames.h"
#include "tests/helpers.h"
#include "tests/png_file.h"

#include "core/system/file.h"
#include "core/export/sheets/bleed.h"
#include "core/export/sheets/flipbook.h"
#include "core/export/data/particle_dump.h"
#include "core/export/sequence.h"
#include "core/rendering/view_transform.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

#include <map>
#include <set>

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

SequenceOptions options(const std::string& output, FrameRange frames)
{
    SequenceOptions out;
    out.output = output;
    out.frames = frames;
    return out;
}

std::string textOf(const std::vector<std::byte>& bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

} // namespace

class ExportTest : public QObject {
    Q_OBJECT

private slots:
    void everyPictureThatIsShownHasTheChosenBackground()
    {
        Effect effect;
        effect.output.background = Background::Colour;
        effect.output.backgroundColour = {0.05F, 0.1F, 0.18F};
        for (const ViewTransform transform : {ViewTransform::Standard, ViewTransform::Filmic}) {
            for (const float exposure : {-1.0F, 0.0F, 2.0F}) {
                effect.output.viewTransform = transform;
                effect.output.exposure = exposure;
                for (const ImageFormat format : {ImageFormat::Png8, ImageFormat::Png16}) {
                    const float full = format == ImageFormat::Png8 ? 255.0F : 65535.0F;
                    const DataImage numbers = sheetNumbers(ramp(), effect, format, 20, 15);
                    const std::vector<std::byte> single = encodeImage(ramp(), effect, format, {}).value();
                    const std::vector<std::byte> sheet = encodeSheet(ramp(), effect, format, 20, 15, {}).value();
                    for (int channel = 0; channel < 3; ++channel) {
                        const float shown = srgbFromLinear(effect.output.backgroundColour[channel]);
                        const int expected = static_cast<int>(shown * full + 0.5F);
                        QVERIFY(std::abs(PngFile(single).at(0, 0, channel) - expected)
                            <= (format == ImageFormat::Png8 ? 0 : 1));
                        QVERIFY(std::abs(PngFile(sheet).at(0, 0, channel) - expected)
                            <= (format == ImageFormat::Png8 ? 0 : 1));
                        QVERIFY(std::abs(numbers.values[static_cast<std::size_t>(channel)] - shown) < 1.0F / full);
                    }
                }
                // before exposure and view transform
                const DataImage light = sheetNumbers(ramp(), effect, ImageFormat::ExrFloat, 20, 15);
                QCOMPARE(light.values[0], effect.output.backgroundColour.r);
                QCOMPARE(light.values[3], 1.0F);
            }
        }
    }

    void png8ReadsBackThroughLibpng()
    {
        const Image image = ramp();
        const std::vector<std::byte> bytes = encodeImage(image, Effect{}, ImageFormat::Png8).value();
        const PngFile png(bytes);
        QVERIFY(png.width == 40 && png.height == 30 && png.bits == 8 && png.colourType == PNG_COLOR_TYPE_RGB_ALPHA);
        EncodedImage<std::uint8_t> expected;
        encode(image, Output{}, expected);
        QVERIFY(std::equal(png.samples.begin(), png.samples.end(), expected.pixels.begin(), expected.pixels.end()));
    }

    void png16HasSixteenBits()
    {
        const std::vector<std::byte> bytes = encodeImage(ramp(), Effect{}, ImageFormat::Png16).value();
        const PngFile png(bytes);
        QVERIFY(png.bits == 16 && png.colourType == PNG_COLOR_TYPE_RGB_ALPHA);
        EncodedImage<std::uint16_t> expected;
        encode(ramp(), Output{}, expected);
        QVERIFY(std::equal(png.samples.begin(), png.samples.end(), expected.pixels.begin(), expected.pixels.end()));
    }

    void exrIsWhatExrheaderSays()
    {
        const QTemporaryDir folder;
        for (const auto& [format, type] : {std::pair{ImageFormat::ExrHalf, "16-bit floating-point"},
                 std::pair{ImageFormat::ExrFloat, "32-bit floating-point"}}) {
            const std::string path = folder.path().toStdString() + "/a.exr";
            QVERIFY(writeFileAtomically(path, encodeImage(ramp(), Effect{}, format).value()).ok());
            QProcess header;
            header.start("exrheader", {QString::fromStdString(path)});
            QVERIFY2(
                header.waitForFinished() && header.exitCode() == 0, "exrheader (package openexr) must be installed");
            const QString text = header.readAllStandardOutput();
            QVERIFY2(text.contains("A, " + QString(type)) && text.contains("R, " + QString(type)), qPrintable(text));
            QVERIFY(text.contains("dataWindow (type box2i): (0 0) - (39 29)"));
        }
    }

    void sameInputGivesTheSameBytes()
    {
        for (const ImageFormat format :
            {ImageFormat::Png8, ImageFormat::Png16, ImageFormat::ExrHalf, ImageFormat::ExrFloat, ImageFormat::Tga}) {
            QVERIFY(encodeImage(ramp(), Effect{}, format).value() == encodeImage(ramp(), Effect{}, format).value());
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
        QCOMPARE(QDir(folder.path() + "/made/here").entryList(QDir::Files),
            QStringList({"f_002.png", "f_005.png", "f_008.png"}));
        std::stop_source stop;
        const SequenceOptions other = options(folder.path().toStdString() + "/other/g_###.png", {0, 50, 1});
        const auto stopAtTwo = [&](int done, int) {
            if (done == 2) {
                stop.request_stop();
            }
        };
        const Status status = renderSequence(effect, other, {stopAtTwo, stop.get_token()});
        QCOMPARE(status.error().code, ErrorCode::Cancelled);
        for (const QString& name : QDir(folder.path() + "/other").entryList(QDir::Files)) {
            QVERIFY(name.endsWith(".png"));
        }
    }

    void cellsOfAFlipbookAreTheFrames()
    {
        const QTemporaryDir folder;
        const std::string path = folder.path().toStdString();
        Effect effect = everythingOn();
        effect.output.width = 40;
        effect.output.height = 24;
        FlipbookOptions flipbook;
        flipbook.output = path + "/new/book";
        flipbook.columns = 3;
        flipbook.rows = 2;
        flipbook.frames = {10, 33, 2}; // twelve, of which the cells show 10, 14, 18, ...
        std::vector<int> progress;
        const Result<Flipbook> done =
            renderFlipbook(effect, flipbook, [&](int count, int) { progress.push_back(count); });
        QVERIFY(done.ok());
        QVERIFY((progress == std::vector<int>{1, 2, 3, 4, 5, 6}));
        QCOMPARE(done.value().picture.string(), path + "/new/book.png");

        const PngFile sheet(done.value().picture.string());
        QVERIFY(sheet.width == 120 && sheet.height == 48);
        for (int cell = 0; cell < 6; ++cell) {
            const int number = 10 + 4 * cell;
            QCOMPARE(frameOfCell(flipbook, cell), number);
            QVERIFY(renderSequence(effect, options(path + "/frame.png", {number, number, 1})).ok());
            const PngFile frame(path + "/frame.png");
            int seen = 0;
            for (int y = 0; y < frame.height; ++y) {
                for (int x = 0; x < frame.width; ++x) {
                    const int alpha = frame.at(x, y, 3);
                    for (int channel = alpha > 0 ? 0 : 3; channel < 4; ++channel) {
                        QCOMPARE(sheet.at(cell % 3 * 40 + x, cell / 3 * 24 + y, channel), frame.at(x, y, channel));
                    }
                    seen += alpha > 0 ? 1 : 0;
                }
            }
            QVERIFY(seen > 50);
        }

        const QJsonObject description =
            QJsonDocument::fromJson(QByteArray::fromStdString(readFile(done.value().description, 10000).value()))
                .object();
        QCOMPARE(description["picture"].toString(), "book.png");
        QCOMPARE(description["columns"].toInt(), 3);
        QCOMPARE(description["cell_height"].toInt(), 24);
        QCOMPARE(description["cells_per_second"].toDouble(), 6 * effect.timeline.frameRate / 24.0);
        QCOMPARE(description["seconds"].toDouble(), 24.0 / effect.timeline.frameRate);
    }

    void aFlipbookSpreadsItsFramesEvenly()
    {
        FlipbookOptions flipbook;
        flipbook.frames = {5, 104, 1};
        QCOMPARE(frameOfCell(flipbook, 0), 5);
        for (int cell = 1; cell < 64; ++cell) {
            const int way = frameOfCell(flipbook, cell) - frameOfCell(flipbook, cell - 1);
            QVERIFY(way == 1 || way == 2);
        }
        QCOMPARE(frameOfCell(flipbook, 63), 5 + 98); // a 64th of the way before the end, where a loop begins anew
    }

    void aFlipbookThatCannotBeIsRefused()
    {
        const QTemporaryDir folder;
        const auto errorOf = [&](int columns, int rows, int frames, int edge) {
            Effect effect = everythingOn();
            effect.output.width = effect.output.height = edge;
            FlipbookOptions flipbook;
            flipbook.output = folder.path().toStdString() + "/a.png";
            flipbook.columns = columns;
            flipbook.rows = rows;
            flipbook.frames = {0, frames - 1, 1};
            return renderFlipbook(effect, flipbook).error().code;
        };
        QCOMPARE(errorOf(0, 8, 100, 16), ErrorCode::OutOfRange);
        QCOMPARE(errorOf(8, 65, 1000, 16), ErrorCode::OutOfRange);
        QCOMPARE(errorOf(8, 8, 63, 16), ErrorCode::OutOfRange);
        QCOMPARE(errorOf(8, 1, 63, 2049), ErrorCode::TooLarge);
        QCOMPARE(errorOf(8, 8, 64, 2048), ErrorCode::TooLarge);
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void colourBleedsUnderTransparencyAndNotIntoOtherCells()
    {
        // Three cells of 5 x 3: one red pixel; a faint green and a strong blue one; nothing.
        EncodedImage<std::uint16_t> image{15, 3, RawArray<std::uint16_t>(15 * 3 * 4, 0)};
        const auto pixel = [&](int x, int y) {
            return image.pixels.data() + static_cast<std::size_t>((y * 15 + x) * 4);
        };
        const auto set = [&](int x, int y, const std::array<std::uint16_t, 4>& to) {
            std::copy(to.begin(), to.end(), pixel(x, y));
        };
        set(4, 1, {60000, 0, 0, 65535});
        set(5, 0, {0, 50000, 0, 1});
        set(9, 2, {0, 0, 40000, 65535});
        bleedColours(image, 5, 3);
        for (int y = 0; y < 3; ++y) {
            for (int x = 0; x < 15; ++x) {
                const std::uint16_t* p = pixel(x, y);
                QCOMPARE(p[3], (x == 4 && y == 1) || (x == 9 && y == 2) ? 65535 : (x == 5 && y == 0 ? 1 : 0));
                QCOMPARE(p[0], x < 5 ? 60000 : 0);
                QVERIFY(x < 10 || (p[1] == 0 && p[2] == 0));
            }
        }
        QCOMPARE(pixel(6, 1)[1], 50000); // beside green alone
        QCOMPARE(pixel(8, 1)[2], 40000); // beside blue alone
    }

    void smokeThatIsCutOffIsToldAbout()
    {
        const QTemporaryDir folder;
        Effect effect;
        effect.emitter.count = 3000;
        effect.look.size = 0.8F;
        effect.output.width = effect.output.height = 32;
        FlipbookOptions flipbook;
        flipbook.output = folder.path().toStdString() + "/a.png";
        flipbook.columns = flipbook.rows = 2;
        flipbook.frames = {30, 33, 1};
        const auto bookFrom = [&](float distance) {
            effect.camera.mode = CameraMode::Orbit;
            effect.camera.distance = distance;
            return renderFlipbook(effect, flipbook).value();
        };
        const Flipbook near = bookFrom(4.0F);
        QVERIFY(near.edgeAlpha > 0.1F);
        QVERIFY(near.cutOff->top);
        QCOMPARE(near.cutOff->firstFrame, 30);
        QCOMPARE(near.cutOff->lastFrame, 33);
        for (const float enough : {near.cutOff->distance, 200.0F}) {
            const Flipbook far = bookFrom(enough);
            QCOMPARE(far.edgeAlpha, 0.0F);
            QVERIFY(!far.cutOff);
        }
    }

    void unwritableFolderIsAnError()
    {
        const Status status = renderSequence(everythingOn(), options("/proc/none/f.png", {0, 0, 1}));
        QVERIFY(!status.ok());
        QVERIFY(status.error().text().find("/proc/none") != std::string::npos);
    }

    void dumpsNameLayersByTheirNumbersInTheScene()
    {
        Scene scene = thesisEffect(50);
        for (std::uint32_t layer = 1; layer < 4; ++layer) {
            scene.layers.push_back(scene.layers.front());
            scene.layers.back().emitter.seed = layer;
        }
        scene.layers[0].visible = false;
        scene.layers[2].visible = false;
        const QByteArray csv = QByteArray::fromStdString(dumpParticles(scene, 20, ParticleFormat::Csv).value());
        QVERIFY(csv.startsWith("layer,id,"));
        std::set<QByteArray> numbers;
        for (const QByteArray& line : csv.trimmed().split('\n').mid(1)) {
            numbers.insert(line.split(',').front());
        }
        QVERIFY((numbers == std::set<QByteArray>{"2", "4"}));
    }

    void dumpsHoldTheLivingParticles()
    {
        const Effect effect = everythingOn();
        const auto frame = frameOf(effect, 4);
        const int alive = livingCount(*frame);
        const QByteArray csv = QByteArray::fromStdString(dumpCsv(*frame, sampled(effect)));
        QCOMPARE(csv.count('\n'), alive + 1);
        QVERIFY(csv.startsWith("id,x,y,z,vx,vy,vz,age,life,alpha,radius,heat,red,green,blue\n"));
        const std::string ply = dumpPly(LayerOf(*frame, effect).span());
        const std::size_t body = ply.find("end_header\n") + 11;
        QVERIFY(ply.find("element vertex " + std::to_string(alive) + "\n") != std::string::npos);
        QCOMPARE(ply.size() - body, static_cast<std::size_t>(alive) * 51);
    }

    void aPointCacheIsInUnitysAxes()
    {
        const Effect effect = everythingOn();
        const auto frame = frameOf(effect, 4);
        const std::string cache = dumpPcache(LayerOf(*frame, effect).span());
        const std::size_t body = cache.find("end_header\n") + 11;
        QVERIFY(cache.rfind("pcache\nformat binary 1.0\n", 0) == 0);
        QVERIFY(cache.find("elements " + std::to_string(livingCount(*frame)) + "\n") != std::string::npos);
        constexpr std::size_t kNumbers = 14;
        QCOMPARE(cache.size() - body, static_cast<std::size_t>(livingCount(*frame)) * kNumbers * 4);
        const QList<QByteArray> lines = QByteArray::fromStdString(dumpCsv(*frame, sampled(effect))).split('\n');
        for (std::size_t i = 0; i < 5; ++i) {
            std::array<float, kNumbers> theirs{};
            std::memcpy(theirs.data(), cache.data() + body + i * sizeof(theirs),
                sizeof(theirs)); // these tests run on little-endian machines
            const QList<QByteArray> ours = lines[static_cast<qsizetype>(i) + 1].split(',');
            const auto column = [&](int at) {
                return ours[at].toFloat();
            }; // id,x,y,z,vx,vy,vz,age,life,alpha,radius,heat,red,green,blue
            QCOMPARE(theirs[0], column(1));
            QCOMPARE(theirs[1], column(2));
            QCOMPARE(theirs[2], -column(3));
            QCOMPARE(theirs[5], -column(6));
            QCOMPARE(theirs[6], column(7));
            QVERIFY(near(theirs[6] / theirs[7], column(8), 1e-5F)); // age over lifetime
            QCOMPARE(theirs[8], 2.0F * column(10));
            QCOMPARE(theirs[9], column(12));
            QCOMPARE(theirs[12], column(9));
            QCOMPARE(theirs[13], column(11));
        }
    }

    void aParticleKeepsItsNumber()
    {
        const Effect effect = everythingOn();
        std::map<int, std::uint32_t> keys;
        int seenBefore = 0;
        for (const int number : {3, 4, 5}) {
            const auto frame = frameOf(effect, number);
            std::vector<std::uint32_t> living;
            for (std::size_t i = 0; i < frame->particles.capacity; ++i) {
                if (lifecycle(*frame, i).alive) {
                    living.push_back(frame->particles.key[i]);
                }
            }
            const QList<QByteArray> lines = QByteArray::fromStdString(dumpCsv(*frame, sampled(effect))).split('\n');
            QCOMPARE(static_cast<std::size_t>(lines.size()), living.size() + 2);
            std::set<int> numbers;
            for (std::size_t i = 0; i < living.size(); ++i) {
                const int id = lines[static_cast<qsizetype>(i) + 1].split(',').first().toInt();
                numbers.insert(id);
                seenBefore += keys.count(id) > 0 ? 1 : 0;
                QCOMPARE(keys.try_emplace(id, living[i]).first->second, living[i]);
            }
            QCOMPARE(numbers.size(), living.size());
            QVERIFY(*numbers.begin() >= 0);
        }
        QVERIFY(seenBefore > 0);
    }

    void upMayBeZ()
    {
        const Effect effect = everythingOn();
        const auto frame = frameOf(effect, 4);
        const auto firstOf = [&](UpAxis up) {
            return QByteArray::fromStdString(dumpCsv(*frame, sampled(effect), up)).split('\n')[1].split(',');
        };
        const QList<QByteArray> y = firstOf(UpAxis::Y);
        const QList<QByteArray> z = firstOf(UpAxis::Z);
        for (const int vector : {1, 4}) {
            QCOMPARE(z[vector], y[vector]);
            QCOMPARE(z[vector + 1].toFloat(), -y[vector + 2].toFloat());
            QCOMPARE(z[vector + 2], y[vector + 1]);
        }
        QCOMPARE(z.mid(7), y.mid(7));
    }

    void filesSayWhatTheyHold()
    {
        const std::string exr = textOf(encodeImage(ramp(), Effect{}, ImageFormat::ExrHalf, {24, {}, 0}).value());
        for (const char* attribute : {"chromaticities", "framesPerSecond", "software", "Fumage"}) {
            QVERIFY2(exr.find(attribute) != std::string::npos, attribute);
        }
        QVERIFY(textOf(encodeImage(ramp(), Effect{}, ImageFormat::ExrHalf).value()).find("framesPerSecond")
            == std::string::npos);
        QVERIFY(textOf(encodeImage(ramp(), Effect{}, ImageFormat::Png8).value())
                    .find(std::string("tEXtSoftware\0Fumage", 19))
            != std::string::npos);
    }

    void encodingCanBeCancelled()
    {
        std::stop_source stop;
        stop.request_stop();
        for (const ImageFormat format :
            {ImageFormat::Png8, ImageFormat::Png16, ImageFormat::ExrHalf, ImageFormat::ExrFloat}) {
            const auto bytes = encodeImage(ramp(), Effect{}, format, {}, stop.get_token());
            QVERIFY(!bytes.ok());
            QCOMPARE(bytes.error().code, ErrorCode::Cancelled);
        }
    }

    void idsInADumpAreUniqueAndStayWithTheirParticles()
    {
        // Also where a loop is shorter than a life, so that particles with the same random numbers are alive at once.
        for (const bool loop : {false, true}) {
            Effect effect = everythingOn();
            effect.timeline.loop = loop;
            effect.timeline.length = 30;
            const SampledEffect smoke = sampled(effect);
            Simulator simulator(smoke);
            const auto agesById = [&](int number) {
                const auto frame = simulator.frame(number).value();
                QMap<QByteArray, double> ages;
                const QList<QByteArray> lines = QByteArray::fromStdString(dumpCsv(*frame, smoke)).trimmed().split('\n');
                for (const QByteArray& line : lines.sliced(1)) {
                    const QList<QByteArray> values = line.split(',');
                    ages.insert(values.at(0), values.at(7).toDouble());
                }
                return ages.size() == livingCount(*frame) ? ages : QMap<QByteArray, double>();
            };
            const QMap<QByteArray, double> before = agesById(21);
            const QMap<QByteArray, double> after = agesById(22);
            QVERIFY(!before.isEmpty() && !after.isEmpty());
            int seen = 0;
            for (auto each = before.begin(); each != before.end(); ++each) {
                if (after.contains(each.key())) {
                    ++seen;
                    QVERIFY(near(after.value(each.key()), each.value() + 1.0 / effect.timeline.frameRate, 1e-5));
                }
            }
            QVERIFY(seen > before.size() * 9 / 10);
        }
    }
};

QTEST_GUILESS_MAIN(ExportTest)
#include "export_test.moc"
