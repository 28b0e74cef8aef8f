// Light maps, motion vectors and the other passes: what they say, how they are stored, and the same bits everywhere.

#include "tests/helpers.h"
#include "tests/png_file.h"

#include "core/system/file.h"
#include "core/base/parallel.h"
#include "core/export/sequence.h"
#include "core/export/sheets/flipbook_files.h"
#include "core/export/sheets/sheet.h"
#include "core/export/sheets/sheet_metrics.h"
#include "core/preset/preset_file.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>

#include <algorithm>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// A cloud that drifts without changing: along x and y at the same speed.
Effect drifting(glm::vec3 velocity)
{
    Effect e = thesisEffect(4000);
    e.emitter.mode = EmissionMode::Burst;
    e.emitter.shape = EmitterShape::Sphere;
    e.emitter.normal = glm::normalize(velocity);
    e.emitter.speed = glm::length(velocity);
    e.life.fadeRate = 0.001F;
    e.look.size = 0.4F;
    e.camera.target = glm::vec3(0.0F);
    e.camera.distance = 9.0F;
    e.camera.pitch = 0.0F;
    e.camera.yaw = 0.0F;
    e.output.width = 64;
    e.output.height = 64;
    return e;
}

/// The passes that a test looks at, of a small sheet.
struct Made {
    PassSheet sheet;
    PassStyle style;

    Made(const Effect& effect, const std::vector<int>& frames, PassSet passes, PassStyle wanted = {})
        : style(wanted)
    {
        passes.add(Pass::Alpha);
        const Status status = renderSheet(effect, {frames}, static_cast<int>(frames.size()), passes, sheet, {});
        if (!status) {
            qFatal("%s", status.error().text().c_str());
        }
    }
    [[nodiscard]] DataImage picture(Pass pass) const { return PassPictures(sheet, {pass}, style).picture(pass); }
    [[nodiscard]] float alphaAt(int x, int y) const { return sheet.targets.of(PassTarget::Colour).at(x, y).a; }
};

/// Mean of a channel where there is smoke.
double meanInSmoke(const Made& made, const DataImage& image, int channel)
{
    double sum = 0.0;
    double weight = 0.0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double a = made.alphaAt(x, y);
            sum += a * image.values[static_cast<std::size_t>((y * image.width + x) * image.channels + channel)];
            weight += a;
        }
    }
    return sum / weight;
}

/// The four channels of the picture itself, of an EXR in memory.
std::vector<float> colourOf(const std::vector<std::byte>& bytes)
{
    const QTemporaryDir folder;
    const std::string path = folder.path().toStdString() + "/picture.exr";
    if (!writeFileAtomically(path, bytes)) {
        qFatal("%s", path.c_str());
    }
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    const std::size_t width = static_cast<std::size_t>(window.max.x) + 1;
    std::vector<float> values(width * (static_cast<std::size_t>(window.max.y) + 1) * 4);
    Imf::FrameBuffer buffer;
    for (std::size_t i = 0; i < 4; ++i) {
        buffer.insert(std::string(1, "RGBA"[i]),
            Imf::Slice(
                Imf::FLOAT, reinterpret_cast<char*>(values.data() + i), 4 * sizeof(float), 4 * sizeof(float) * width));
    }
    file.setFrameBuffer(buffer);
    file.readPixels(0, window.max.y);
    return values;
}

Effect preset(const char* name)
{
    return readPresetFile(std::string(FUMAGE_SOURCE_DIR "/resources/presets/") + name + ".json")
        .value()
        .preset.scene.effect();
}

} // namespace

class PassesTest : public QObject {
    Q_OBJECT

private slots:
    void vectorsPointWhereTheSmokeGoes_data()
    {
        QTest::addColumn<float>("right");
        QTest::addColumn<float>("up");
        QTest::newRow("right") << 1.5F << 0.0F;
        QTest::newRow("up") << 0.0F << 1.5F;
        QTest::newRow("left and down") << -1.1F << -1.1F;
    }
    void vectorsPointWhereTheSmokeGoes()
    {
        QFETCH(float, right);
        QFETCH(float, up);
        const Effect effect = drifting({right, up, 0.0F});
        const Made unity(effect, {10, 18, 26}, {Pass::Motion});
        const PassPictures pictures(unity.sheet, {Pass::Motion}, {});
        const DataImage motion = pictures.picture(Pass::Motion);
        // Focal length as a share of the picture, over the distance, times eight frames.
        const float share = 50.0F / kSensorMillimetres / 9.0F * 8.0F / 30.0F;
        QVERIFY(near(meanInSmoke(unity, motion, 0) * pictures.scales().motion, right * share, 0.1 * share));
        QVERIFY(near(meanInSmoke(unity, motion, 1) * pictures.scales().motion, up * share, 0.1 * share));
        PassStyle style;
        style.vectors = VectorSigns::Unreal;
        const DataImage unreal = PassPictures(unity.sheet, {Pass::Motion}, style).picture(Pass::Motion);
        for (std::size_t i = 0; i < motion.values.size(); i += 3) {
            QVERIFY(unreal.values[i] == -motion.values[i] && unreal.values[i + 1] == motion.values[i + 1]);
        }
    }

    void vectorsGoOnBeyondTheSmoke()
    {
        const Made made(drifting({1.5F, 0.0F, 0.0F}), {10, 18}, {Pass::Motion});
        const DataImage motion = made.picture(Pass::Motion);
        int outside = 0;
        for (int y = 0; y < motion.height; ++y) {
            for (int x = 0; x < motion.width; ++x) {
                if (made.alphaAt(x, y) == 0.0F) {
                    ++outside;
                    QVERIFY(motion.values[static_cast<std::size_t>(y * motion.width + x) * 3] > 0.2F);
                }
            }
        }
        QVERIFY(outside > 100);
    }

    void halfIsNoMotionInPng()
    {
        QCOMPARE(quantised(0.0F, true, 255), 128);
        QCOMPARE(quantised(1.0F, true, 255), 255);
        QCOMPARE(quantised(-1.0F, true, 255), 0);
        QCOMPARE(quantised(2.0F, false, 65535), 65535);
    }

    void lightFromEachSideIsBrightestThere()
    {
        // A ball of dense smoke: each map is brighter on the side that its light comes from.
        Effect ball = drifting({0.01F, 0.0F, 0.0F});
        ball.look.opacity = 8.0F;
        ball.light.shadow = 3.0F;
        ball.light.anisotropy = 0.0F;
        const Made made(ball, {5}, {Pass::SixWayA, Pass::SixWayB});
        const DataImage a = made.picture(Pass::SixWayA);
        const DataImage b = made.picture(Pass::SixWayB);
        const auto slope = [&](const DataImage& map, int channel, bool down) {
            double sum = 0.0;
            for (int y = 0; y < map.height; ++y) {
                for (int x = 0; x < map.width; ++x) {
                    const double place = (down ? y : x) - 31.5;
                    sum += place * made.alphaAt(x, y)
                        * map.values[static_cast<std::size_t>((y * map.width + x) * 4 + channel)];
                }
            }
            return sum;
        };
        QVERIFY(slope(a, 0, false) > 1.0); // right
        QVERIFY(slope(b, 0, false) < -1.0); // left
        QVERIFY(slope(a, 1, true) < -1.0); // top
        QVERIFY(slope(b, 1, true) > 1.0); // bottom
        QVERIFY(meanInSmoke(made, b, 2) > 1.5 * meanInSmoke(made, a, 2)); // front and back
    }

    void layoutsHoldTheSameLight()
    {
        const Made made(everythingOn(), {20}, {Pass::SixWayA, Pass::SixWayB});
        const PassPictures unity(made.sheet, {Pass::SixWayA, Pass::SixWayB}, {});
        const std::array<DataImage, 2> maps{unity.picture(Pass::SixWayA), unity.picture(Pass::SixWayB)};
        const auto unityChannels = channelsOf(SixWayLayout::Unity);
        for (const SixWayLayout layout : {SixWayLayout::EmberGen, SixWayLayout::RltBbf, SixWayLayout::TlrbFb}) {
            PassStyle style;
            style.layout = layout;
            const PassPictures others(made.sheet, {Pass::SixWayA, Pass::SixWayB}, style);
            const auto channels = channelsOf(layout);
            for (std::size_t map = 0; map < 2; ++map) {
                const DataImage other = others.picture(map == 0 ? Pass::SixWayA : Pass::SixWayB);
                for (std::size_t channel = 0; channel < 4; ++channel) {
                    for (std::size_t in = 0; in < 8; ++in) {
                        if (unityChannels[in / 4][in % 4] == channels[map][channel]) {
                            for (std::size_t i = 0; i < other.values.size(); i += 4) {
                                QCOMPARE(other.values[i + channel], maps[in / 4].values[i + in % 4]);
                            }
                        }
                    }
                }
            }
        }
    }

    void densityIsTheOpticalDepthOfAlpha()
    {
        const Made made(drifting({1.5F, 0.7F, 0.0F}), {10}, {Pass::Density});
        const PassPictures pictures(made.sheet, {Pass::Density}, {});
        const DataImage density = pictures.picture(Pass::Density);
        QCOMPARE(density.channels, 1);
        float most = 0.0F;
        for (int y = 0; y < density.height; ++y) {
            for (int x = 0; x < density.width; ++x) {
                const float share = density.values[static_cast<std::size_t>(y * density.width + x)];
                most = std::max(most, share);
                QVERIFY(std::abs(1.0F - std::exp(-share * pictures.scales().density) - made.alphaAt(x, y)) < 1e-5F);
            }
        }
        QCOMPARE(most, 1.0F);
        QVERIFY(pictures.scales().density > 0.5F);
    }

    void whatNothingComesThroughHasADepthOfItsOwn()
    {
        PassSheet sheet;
        sheet.grid = {1, 1, 3, 1};
        Image& colour = sheet.targets.of(PassTarget::Colour);
        colour.resize(3, 1);
        colour.pixels[3] = 0.0F;
        colour.pixels[7] = 0.5F;
        colour.pixels[11] = 1.0F;
        const PassPictures pictures(sheet, {Pass::Density}, {});
        const DataImage density = pictures.picture(Pass::Density);
        const float scale = pictures.scales().density;
        QCOMPARE(density.values[0], 0.0F);
        QVERIFY(std::abs(density.values[1] * scale - std::log(2.0F)) < 1e-6F);
        QVERIFY(std::abs(density.values[2] * scale - 23.0F * std::log(2.0F)) < 1e-4F);
    }

    void clearFlamesAreMeasuredUnderLightAsTheyAreShown()
    {
        // Without shadows and with light that goes all ways alike six maps hold all there is, flames or not.
        Effect effect = drifting({1.5F, 0.7F, 0.0F});
        effect.light.shadow = 0.0F;
        effect.light.anisotropy = 0.0F;
        effect.glow.emission = 4.0F;
        effect.glow.flameOpacity = 0.05F;
        effect.glow.emissionCooling = 0.5F;
        FlipbookOptions options;
        options.columns = 2;
        options.rows = 1;
        options.frames = {10, 13, 2};
        options.format = ImageFormat::ExrFloat;
        const Result<SheetScore> score = scoreSheet(effect, options, 1);
        QVERIFY(score.ok());
        QVERIFY2(score.value().sixWay.worst > 55.0, qPrintable(QString::number(score.value().sixWay.worst)));
    }

    void relitMapsAreTheSmokeUnderThatLight_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("decibels");
        // A decibel below what was measured; peak 1, 20 directions.
        QTest::newRow("steam") << "steam" << 28.8;
        QTest::newRow("default") << "default" << 29.5;
        QTest::newRow("dust") << "dust" << 29.0;
    }
    void relitMapsAreTheSmokeUnderThatLight()
    {
        QFETCH(QString, name);
        QFETCH(double, decibels);
        Effect effect = preset(name.toUtf8().constData());
        effect.output.width = 64;
        effect.output.height = 64;
        FlipbookOptions options;
        options.columns = 2;
        options.rows = 1;
        options.frames = {20, 23, 2};
        const Result<SheetScore> score = scoreSheet(effect, options, 1);
        QVERIFY(score.ok());
        QVERIFY2(score.value().sixWay.decibels > decibels, qPrintable(QString::number(score.value().sixWay.decibels)));
        QVERIFY(score.value().motion.between == 1);
    }

    void vectorsRebuildWhatACrossFadeBlurs()
    {
        FlipbookOptions options;
        options.columns = 3;
        options.rows = 1;
        options.frames = {10, 33, 8};
        const Result<SheetScore> score = scoreSheet(drifting({1.5F, 0.7F, 0.0F}), options, 1);
        QVERIFY(score.ok());
        QVERIFY2(score.value().motion.rebuilt > score.value().motion.crossFaded + 6.0,
            qPrintable(QStringLiteral("%1 %2").arg(score.value().motion.rebuilt).arg(score.value().motion.crossFaded)));
    }

    void sameBitsWhateverTheThreadsAndInstructionSet()
    {
        const SimdGuard guard;
        const PassSet all = parsePasses("all").value();
        Effect effect = everythingOn();
        effect.output.width = 50;
        effect.output.height = 70;
        const auto make = [&] {
            const Made made(effect, {20, 22}, all);
            const PassPictures pictures(made.sheet, all, {});
            std::vector<RawArray<float>> values;
            for (const Pass pass : listOf(all)) {
                values.push_back(pass == Pass::Colour ? made.sheet.targets.of(PassTarget::Colour).pixels
                                                      : pictures.picture(pass).values);
            }
            return values;
        };
        const auto expected = make();
        const auto same = [&](const std::vector<RawArray<float>>& seen) {
            for (std::size_t i = 0; i < seen.size(); ++i) {
                if (seen[i].size() != expected[i].size()
                    || std::memcmp(seen[i].data(), expected[i].data(), seen[i].size() * sizeof(float)) != 0) {
                    qWarning("%s differs", std::string(passName(kAllPasses[i])).c_str());
                    return false;
                }
            }
            return true;
        };
        for (const int threads : {1, 2, 7}) {
            const ThreadLimit limit(threads);
            QVERIFY(same(make()));
        }
        for (const std::string& name : availableSimdTargets()) {
            QVERIFY(forceSimdTarget(name).ok());
            QVERIFY2(same(make()), name.c_str());
        }
    }

    void theColourIsThatOfTheFlipbookAlone()
    {
        const QTemporaryDir folder;
        Effect effect = everythingOn();
        FlipbookOptions options;
        options.columns = 2;
        options.rows = 1;
        options.frames = {20, 21, 1};
        options.output = folder.path().toStdString() + "/alone";
        QVERIFY(renderFlipbook(effect, options).ok());
        options.output = folder.path().toStdString() + "/both";
        options.passes = {Pass::Colour, Pass::SixWayA, Pass::Motion, Pass::Albedo, Pass::Shadow};
        QVERIFY(renderFlipbook(effect, options).ok());
        const auto bytes = [&](const char* name) {
            return readFile(folder.path().toStdString() + name, 10'000'000).value();
        };
        QVERIFY(bytes("/alone.png") == bytes("/both.png"));
    }

    void targetsOfAnExrAreThePassesInTheirUnits()
    {
        const QTemporaryDir folder;
        const Effect effect = drifting({1.0F, 1.0F, 0.0F});
        SequenceOptions options;
        options.output = folder.path().toStdString() + "/smoke_##.exr";
        options.frames = {20, 22, 1};
        options.format = ImageFormat::ExrFloat;
        options.passes = {Pass::Motion, Pass::Depth, Pass::SixWayA};
        QVERIFY(renderSequence(effect, options).ok());
        QCOMPARE(
            QDir(folder.path()).entryList(QDir::Files), QStringList({"smoke_20.exr", "smoke_21.exr", "smoke_22.exr"}));
        Imf::InputFile file(folder.filePath("smoke_21.exr").toStdString().c_str());
        QStringList names;
        for (auto channel = file.header().channels().begin(); channel != file.header().channels().end(); ++channel) {
            names << channel.name();
        }
        QCOMPARE(names,
            QStringList({"A", "B", "G", "R", "depth.Z", "motion.X", "motion.Y", "motion.Z", "sixway_a.A", "sixway_a.B",
                "sixway_a.G", "sixway_a.R"}));
        constexpr int kSize = 64;
        std::vector<float> values(std::size_t{4} * kSize * kSize);
        std::vector<float> inwards(std::size_t{1} * kSize * kSize, 1.0F);
        Imf::FrameBuffer buffer;
        buffer.insert("motion.Z",
            Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(inwards.data()), sizeof(float), sizeof(float) * kSize));
        for (const auto& [name, at] :
            {std::pair{"A", 0}, std::pair{"motion.X", 1}, std::pair{"motion.Y", 2}, std::pair{"depth.Z", 3}}) {
            buffer.insert(name,
                Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data() + at), 4 * sizeof(float),
                    4 * sizeof(float) * kSize));
        }
        file.setFrameBuffer(buffer);
        file.readPixels(0, kSize - 1);
        QVERIFY(std::ranges::all_of(inwards, [](float value) { return value == 0.0F; }));
        double sum[4] = {};
        for (std::size_t i = 0; i < values.size(); i += 4) {
            for (std::size_t channel = 1; channel < 4; ++channel) {
                sum[channel] += double(values[i]) * double(values[i + channel]);
            }
            sum[0] += double(values[i]);
        }
        // 1 m/s at 30 frames/s, 9 m away, through the focal length in pixels; the cloud is about its middle.
        const View view = makeView(effect.camera, 0.0F, kSize, kSize);
        const double expected = double(view.focal) / 9.0 / 30.0;
        QVERIFY2(
            std::abs(sum[1] / sum[0] / expected - 1.0) < 0.05, qPrintable(QString::number(sum[1] / sum[0] / expected)));
        QVERIFY2(
            std::abs(sum[2] / sum[0] / expected - 1.0) < 0.05, qPrintable(QString::number(sum[2] / sum[0] / expected)));
        QVERIFY2(std::abs(sum[3] / sum[0] - 9.0) < 0.5, qPrintable(QString::number(sum[3] / sum[0])));
    }

    void theColourOfTargetsIsTheFrameAlone()
    {
        const Effect effect = everythingOn();
        SequenceOptions options;
        options.format = ImageFormat::ExrFloat;
        const auto alone = encodeFrame(effect, 20, options);
        options.passes = {Pass::Colour, Pass::Depth};
        const auto targeted = encodeFrame(effect, 20, options);
        QVERIFY(alone.ok() && targeted.ok());
        QVERIFY(colourOf(targeted.value()) == colourOf(alone.value()));
        options.format = ImageFormat::Png8;
        const auto png = encodeFrame(effect, 20, options);
        QVERIFY(!png.ok() && png.error().text().find("EXR") != std::string::npos);
    }

    void dataIsLinearAndSaysSo()
    {
        const QTemporaryDir folder;
        const std::string base = folder.path().toStdString();
        FlipbookOptions options;
        options.output = base + "/smoke.png";
        options.columns = 2;
        options.rows = 1;
        options.frames = {20, 21, 1};
        options.passes = {Pass::Colour, Pass::SixWayA, Pass::SixWayB, Pass::Motion, Pass::Depth};
        const Result<Flipbook> flipbook = renderFlipbook(everythingOn(), options);
        QVERIFY(flipbook.ok());
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files, QDir::Name),
            QStringList({"smoke.flipbook.json", "smoke.png", "smoke_depth.png", "smoke_motion.png",
                "smoke_sixway_a.png", "smoke_sixway_b.png"}));
        QVERIFY(PngFile(base + "/smoke.png").hasSrgb);
        for (const auto& [name, type] : {std::pair{"/smoke_sixway_a.png", PNG_COLOR_TYPE_RGB_ALPHA},
                 std::pair{"/smoke_motion.png", PNG_COLOR_TYPE_RGB},
                 std::pair{"/smoke_depth.png", PNG_COLOR_TYPE_GRAY}}) {
            const PngFile picture(base + name);
            QVERIFY2(!picture.hasSrgb && !picture.hasGamma && picture.colourType == type, name);
        }
        // Engines read PNG with libpng's simplified interface, which turns what has a gamma into sRGB: vectors must
        // come out as they were stored.
        png_image image{};
        image.version = PNG_IMAGE_VERSION;
        QVERIFY(png_image_begin_read_from_file(&image, (base + "/smoke_motion.png").c_str()) != 0);
        image.format = PNG_FORMAT_RGB;
        std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(image));
        QVERIFY(png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr) != 0);
        QCOMPARE(int(bytes[0]), 128);
        QCOMPARE(int(bytes[2]), 128);
        const QJsonObject description =
            QJsonDocument::fromJson(QByteArray::fromStdString(readFile(flipbook.value().description, 100000).value()))
                .object();
        const QJsonArray pictures = description["pictures"].toArray();
        QCOMPARE(pictures.size(), 5);
        QCOMPARE(pictures[0].toObject()["colour"].toString(), "sRGB");
        QCOMPARE(pictures[1].toObject()["file"].toString(), "smoke_sixway_a.png");
        QCOMPARE(pictures[1].toObject()["colour"].toString(), "linear");
        QCOMPARE(pictures[1].toObject()["layout"].toString(), "unity");
        QCOMPARE(pictures[1].toObject()["channels"].toArray()[1].toString(), "top");
        QVERIFY(pictures[1].toObject()["scale"].toDouble() >= 1.0);
        QCOMPARE(pictures[3].toObject()["pass"].toString(), "motion");
        QVERIFY(pictures[3].toObject()["scale"].toDouble() > 0.0);
        QCOMPARE(pictures[3].toObject()["centre"].toDouble(), 0.5);
    }
};

QTEST_APPLESS_MAIN(PassesTest)
#include "passes_test.moc"
