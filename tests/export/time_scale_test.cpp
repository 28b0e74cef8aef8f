// timeline.time_scale: twice of it at twice the frame rate is the same smoke to the bit, and what is written besides
// pictures is in seconds of the film.
#include "tests/live/live_scene_helpers.h"

#include "core/export/data/air_file.h"
#include "core/export/data/particle_dump.h"
#include "core/export/data/volume.h"
#include "core/export/sheets/sheet.h"
#include "core/live/live_scene.h"
#include "core/preset/library.h"
#include "core/simulation/air_cache.h"
#include "core/simulation/simulation_model.h"

#include <algorithm>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr PassSet kPasses{Pass::Colour, Pass::Motion};

Scene small(Scene scene)
{
    scene.air.resolution = kMinAirResolution;
    scene.output.quality = Quality::Draft;
    scene.output.supersample = 1;
    scene.output.width = scene.output.height = 32;
    for (Layer& layer : scene.layers) {
        layer.emitter.count = std::min(layer.emitter.count, 500);
        layer.noise.resolution = 16;
        layer.noise.slices = 4;
    }
    return scene;
}

Tracks twiceAsFast(const Tracks& tracks)
{
    Tracks out;
    for (Track track : tracks.all()) {
        for (KeyFrame& key : track.keys) {
            key.seconds /= 2.0;
            key.slopeIn *= 2.0F;
            key.slopeOut *= 2.0F;
        }
        out.set(std::move(track));
    }
    return out;
}

/// The same smoke in the same frames, of which twice as many pass in a second: what the film has in its own seconds
/// takes half as many, what the smoke has stays.
Scene twiceAsFast(Scene scene)
{
    scene.timeline.frameRate *= 2;
    scene.timeline.timeScale *= 2.0F;
    scene.camera.turntable *= 2.0F;
    scene.tracks = twiceAsFast(scene.tracks);
    for (Layer& layer : scene.layers) {
        layer.emitter.start /= 2.0F;
        layer.emitter.length /= 2.0F;
        layer.look.stretch /= 2.0F;
        layer.tracks = twiceAsFast(layer.tracks);
    }
    return scene;
}

PassSheet sheetOf(const Scene& scene)
{
    const int length = scene.timeline.length;
    PassSheet sheet;
    if (const Status status = renderSheet(scene, {{length / 8, length / 2}}, 2, kPasses, sheet, {}); !status) {
        qFatal("%s", status.error().text().c_str());
    }
    return sheet;
}

Effect plume()
{
    Effect effect = thesisEffect(600);
    effect.air.enabled = true;
    effect.air.resolution = kMinAirResolution;
    effect.motion.buoyancy = effect.air.buoyancy = 2.0F;
    return effect;
}

QList<QByteArrayList> rowsOf(const Effect& effect)
{
    constexpr int kFrame = 30;
    const auto text = QByteArray::fromStdString(dumpCsv(*frameOf(effect, kFrame), sampled(effect)));
    QList<QByteArrayList> rows;
    for (const QByteArray& line : text.trimmed().split('\n').mid(1)) {
        rows.append(line.split(','));
    }
    return rows;
}

Particles playedInAGame(Effect effect, int stepsPerSecond, const glm::vec3& velocity)
{
    effect.timeline.prewarm = false;
    LiveOptions options;
    options.stepsPerSecond = stepsPerSecond;
    LiveScene live = startedScene(effect, options);
    for (int step = 0; step < 40; ++step) {
        const float way = 0.02F * static_cast<float>(step);
        [&] { QVERIFY(live.setEmitters({{way, 0.0F, 0.0F}, kUp, velocity}).ok()); }();
        go(live, 1);
    }
    return live.particles(0);
}

} // namespace

class TimeScaleTest : public QObject {
    Q_OBJECT

private slots:
    void twiceOfItAtTwiceTheFrameRateIsTheSameToTheBit_data()
    {
        QTest::addColumn<QString>("preset");
        for (const LibraryEntry& entry : builtinPresets()) {
            QTest::newRow(entry.id.c_str()) << QString::fromStdString(entry.id);
        }
    }

    void twiceOfItAtTwiceTheFrameRateIsTheSameToTheBit()
    {
        QFETCH(QString, preset);
        const Scene scene = small(loadPreset(preset.toStdString()).value().preset.scene);
        const PassSheet expected = sheetOf(scene);
        const PassSheet fast = sheetOf(twiceAsFast(scene));
        for (const PassTarget target : {PassTarget::Colour, PassTarget::Motion}) {
            QVERIFY(!expected.targets.of(target).pixels.empty());
            QVERIFY(sameBits(expected.targets.of(target).pixels, fast.targets.of(target).pixels));
        }
        QVERIFY(std::ranges::any_of(expected.targets.of(PassTarget::Motion).pixels, [](float x) { return x != 0.0F; }));
    }

    void itIsNotTheSameAtTheSameFrameRate()
    {
        Effect effect = plume();
        const auto frame = frameOf(effect, 20);
        effect.timeline.timeScale = 2.0F;
        QVERIFY(!sameBits(frame->particles, frameOf(effect, 20)->particles));
    }

    void particlesAreWrittenInSecondsOfTheFilm()
    {
        const Effect effect = plume();
        const QList<QByteArrayList> rows = rowsOf(effect);
        const QList<QByteArrayList> fast = rowsOf(twiceAsFast(effect).effect());
        QVERIFY(rows.size() > 100);
        QCOMPARE(fast.size(), rows.size());
        constexpr int kVelocity = 4; // after id, x, y, z
        constexpr int kAge = 7;
        double most = 0.0;
        for (int row = 0; row < rows.size(); ++row) {
            for (int column = 0; column < rows[row].size(); ++column) {
                const bool isVelocity = column >= kVelocity && column < kAge;
                const double factor = isVelocity ? 2.0 : column == kAge ? 0.5 : 1.0;
                QCOMPARE(fast[row][column].toFloat(), static_cast<float>(factor * rows[row][column].toDouble()));
            }
            most = std::max(most, rows[row][kVelocity + 1].toDouble());
        }
        QVERIFY(most > 0.1);
    }

    void volumesAreWrittenInSecondsOfTheFilm()
    {
        constexpr int kFrame = 30;
        constexpr float kVoxel = 0.1F;
        const Effect effect = plume();
        const Effect fast = twiceAsFast(effect).effect();
        const Volume expected = volumeOf(*frameOf(effect, kFrame), sampled(effect), kVoxel).value();
        const Volume volume = volumeOf(*frameOf(fast, kFrame), sampled(fast), kVoxel).value();
        QVERIFY(sameBits(volume.density, expected.density));
        for (std::size_t cell = 0; cell < volume.velocity.size(); ++cell) {
            QCOMPARE(volume.velocity[cell], 2.0F * expected.velocity[cell]);
        }
        QVERIFY(std::ranges::any_of(expected.velocity, [](const glm::vec3& v) { return v.y > 0.1F; }));
    }

    void airIsWrittenInSecondsOfTheFilm_data()
    {
        QTest::addColumn<AirFormat>("format");
        for (const AirFormat format : kAllAirFormats) {
            QTest::newRow(std::string(fileEnding(format)).c_str()) << format;
        }
    }

    void airIsWrittenInSecondsOfTheFilm()
    {
        QFETCH(AirFormat, format);
        const Scene scene = plume();
        const auto filesOf = [&](const Scene& of) {
            const QTemporaryDir folder;
            AirSequenceOptions options;
            options.output = folder.filePath("air####").toStdString() + std::string(fileEnding(format));
            options.frames = {30, 30};
            options.format = format;
            const Result<AirGrid> written = writeAir(of, options);
            QFile file(QDir(folder.path()).entryInfoList(QDir::Files).value(0).filePath());
            return written && file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        const SampledEffect smoke = sampled(scene.effect());
        AirCache shelf;
        const SimulationModel model(smoke, shelf.airOf(smoke));
        const AirFieldPtr field = model.air()->field(model.schedule().stepOfFrame(30)).value();
        QCOMPARE(filesOf(scene), QByteArray::fromStdString(encodeAir(*field, format)));
        QCOMPARE(filesOf(twiceAsFast(scene)), QByteArray::fromStdString(encodeAir(*field, format, 2.0F)));
        QVERIFY(encodeAir(*field, format) != encodeAir(*field, format, 2.0F));
    }

    void itIsPlayedInAGame()
    {
        Effect effect = plume();
        const glm::vec3 velocity(0.6F, 0.0F, 0.2F);
        const Particles expected = playedInAGame(effect, 30, velocity);
        effect.timeline.timeScale = 2.0F;
        QVERIFY(sameBits(playedInAGame(effect, 60, 2.0F * velocity), expected));
        QVERIFY(!sameBits(playedInAGame(effect, 60, velocity), expected));
    }
};

QTEST_GUILESS_MAIN(TimeScaleTest)
#include "time_scale_test.moc"
