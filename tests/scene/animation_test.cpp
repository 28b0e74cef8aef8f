// What changes over time: values between key frames, when they are read, and what they do to particles and pictures.

#include "tests/helpers.h"
#include "tests/parameter_rows.h"
#include "tests/parameter_stage.h"
#include "tests/scene/scene_pictures.h"

#include "core/preset/preset_file.h"
#include "core/rendering/scene_renderer.h"
#include "core/scene/key_assignment.h"

#include <algorithm>
#include <cmath>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kFrame = 9;
constexpr const Parameter& kRate = knownParameter("emitter.rate");

Track trackOf(const Parameter& parameter, std::vector<KeyFrame> keys)
{
    return {&parameter, std::move(keys)};
}

Scene withTrack(const Effect& effect, const Track& track)
{
    Scene scene = effect;
    scene.tracksOf(*track.parameter, 0).set(track);
    return scene;
}

std::shared_ptr<const Frame> frameOfScene(const Scene& scene, int number)
{
    return SceneSimulator(sampledLayers(scene)).frame(number).value().layers.front();
}

bool sameFrame(const Frame& a, const Frame& b)
{
    return tests::sameBits(a.particles, b.particles);
}

bool nearFrame(const Frame& a, const Frame& b)
{
    bool same = a.particles.capacity == b.particles.capacity;
    for (std::size_t i = 0; same && i < a.particles.capacity; ++i) {
        same = std::abs(a.particles.x[i] - b.particles.x[i]) + std::abs(a.particles.y[i] - b.particles.y[i]) < 1e-4F;
    }
    return same;
}

/// The largest difference of a channel.
float farthest(const Image& a, const Image& b)
{
    float most = 0.0F;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const glm::vec4 apart = glm::abs(a.at(x, y) - b.at(x, y));
            most = std::max({most, apart.r, apart.g, apart.b, apart.a});
        }
    }
    return most;
}

float numberAt(const Track& track, double seconds)
{
    return std::get<float>(track.at(seconds));
}

/// A random number, the same each time.
double drawn(std::uint32_t& state)
{
    state = state * 1664525U + 1013904223U;
    return static_cast<double>(state >> 8U) / 16777216.0;
}

/// A stage on which a row does something, without what would differ for the sake of room.
Effect stageOf(const Parameter& row)
{
    Effect effect = stageFor(row);
    // Of thin smoke not everything is seen, and the second ring comes late.
    effect.timeline.prewarm = row.animates == Animates::Frame || row.group() == "rings";
    effect.timeline.loop = false;
    effect.air.fit = false;
    return effect;
}

/// Point particles that stay where they are born, all of them in turn.
Effect dots(int count)
{
    Effect effect = thesisEffect(count);
    effect.emitter.width = 0.0F;
    effect.emitter.depth = 0.0F;
    effect.emitter.speed = 0.0F;
    return effect;
}

void addAnimatedRows(bool (*wanted)(Animates))
{
    QTest::addColumn<QString>("key");
    for (const Parameter& row : parameterTable()) {
        if (canAnimate(row) && wanted(row.animates)) {
            QTest::newRow(row.key.data()) << QString::fromUtf8(row.key.data());
        }
    }
}

std::string textOf(const Scene& scene)
{
    Preset preset;
    preset.scene = scene;
    return formatPreset(preset);
}

} // namespace

class AnimationTest : public QObject {
    Q_OBJECT

private slots:
    void valuesBetweenKeys()
    {
        const Parameter& row = knownParameter("glow.emission");
        Track track = trackOf(row, {{1.0, 2.0F, Ease::Linear}, {3.0, 6.0F, Ease::Hold}, {4.0, 1.0F}});
        QCOMPARE(numberAt(track, 0.0), 2.0F);
        QCOMPARE(numberAt(track, 2.0), 4.0F);
        QCOMPARE(numberAt(track, 3.0), 6.0F);
        QCOMPARE(numberAt(track, 3.999), 6.0F);
        QCOMPARE(numberAt(track, 4.0), 1.0F);
        QCOMPARE(numberAt(track, 9.0), 1.0F);
        track.after = Extrapolation::Loop;
        QCOMPARE(numberAt(track, 5.0), 4.0F); // one after the last is one after the first
        track.after = Extrapolation::PingPong;
        QCOMPARE(numberAt(track, 6.0), 4.0F); // two before the last
        track.before = Extrapolation::PingPong;
        QCOMPARE(numberAt(track, 0.0), 4.0F); // one before the first is one after it
        // A free key has the slope that it says: a cubic between two equal values.
        const Track free = trackOf(
            row, {{0.0, 5.0F, Ease::Free, {}, {4.0F, 0.0F, 0.0F}}, {1.0, 5.0F, Ease::Free, {-4.0F, 0.0F, 0.0F}, {}}});
        QCOMPARE(numberAt(free, 0.5), 6.0F); // 5 + (4 / 8 + 4 / 8)
    }

    void twoAutoKeysAreAStraightLine()
    {
        const Track track = trackOf(knownParameter("glow.emission"), {{0.0, 1.0F}, {2.0, 5.0F}});
        QCOMPARE(numberAt(track, 0.5), 2.0F); // and leave their ends as fast as they come
    }

    void autoKeysNeverOvershoot()
    {
        std::uint32_t state = 7;
        for (int round = 0; round < 200; ++round) {
            Track track = trackOf(knownParameter("look.opacity"), {});
            double seconds = 0.0;
            for (int key = 0; key < 6; ++key) {
                track.keys.push_back({seconds, static_cast<float>(std::floor(4.0 * drawn(state)))});
                seconds += 0.05 + drawn(state);
            }
            for (std::size_t key = 0; key + 1 < track.keys.size(); ++key) {
                const auto [low, high] =
                    std::minmax(std::get<float>(track.keys[key].value), std::get<float>(track.keys[key + 1].value));
                for (int part = 0; part <= 20; ++part) {
                    const double from = track.keys[key].seconds;
                    const float value = numberAt(track, from + (track.keys[key + 1].seconds - from) * part / 20.0);
                    QVERIFY(value >= low - 1e-6F && value <= high + 1e-6F);
                }
            }
        }
    }

    void directionsTurnAndKeepTheirLength()
    {
        const glm::vec3 up{0.0F, 1.0F, 0.0F};
        const glm::vec3 right{1.0F, 0.0F, 0.0F};
        Track track = trackOf(knownParameter("emitter.normal"), {{0.0, up}, {1.0, right}});
        const auto half = std::get<glm::vec3>(track.at(0.5));
        QVERIFY(near(static_cast<double>(glm::length(half)), 1.0, 1e-6));
        QVERIFY(near(static_cast<double>(half.x), static_cast<double>(half.y), 1e-6));
        track.keys.back().value = -up;
        for (int part = 0; part <= 10; ++part) {
            QVERIFY(near(static_cast<double>(glm::length(std::get<glm::vec3>(track.at(part / 10.0)))), 1.0, 1e-6));
        }
    }

    void choicesHold()
    {
        const Track track = trackOf(knownParameter("output.background"), {{0.0, 0}, {1.0, 1}});
        QCOMPARE(std::get<int>(track.at(0.999)), 0);
        QCOMPARE(std::get<int>(track.at(1.0)), 1);
    }

    void aConstantTrackIsTheConstant_data()
    {
        addAnimatedRows([](Animates) { return true; });
    }
    void aConstantTrackIsTheConstant()
    {
        QFETCH(QString, key);
        const Parameter& row = *findParameter(key.toStdString());
        const Effect effect = stageOf(row);
        const Value value = moved(row, effect);
        Effect constant = effect;
        row.set(constant, value);
        const Scene scene = withTrack(effect, trackOf(row, {{0.0, value}, {0.2, value, Ease::Linear}, {0.5, value}}));
        QVERIFY(sameFrame(*frameOfScene(scene, kFrame), *frameOfScene(constant, kFrame)));
        QVERIFY(tests::sameBits(pictureOf(scene, kFrame).pixels, pictureOf(constant, kFrame).pixels));
    }

    void whatIsReadAtAFrameHasItsValueThen_data()
    {
        addAnimatedRows([](Animates when) { return when == Animates::Frame; });
    }
    void whatIsReadAtAFrameHasItsValueThen()
    {
        QFETCH(QString, key);
        const Parameter& row = *findParameter(key.toStdString());
        const Effect effect = stageOf(row);
        const Track track = trackOf(row, {{0.0, row.get(effect), Ease::Linear}, {0.4, moved(row, effect)}});
        Effect then = effect;
        const double seconds = static_cast<double>(kFrame) / effect.timeline.frameRate;
        row.set(then, track.at(seconds));
        const Scene scene = withTrack(effect, track);
        QVERIFY(tests::sameBits(pictureOf(scene, kFrame).pixels, pictureOf(then, kFrame).pixels));
        if (row.group() == "output") {
            QVERIFY(
                row.get(scene.atFrame(kFrame).effect()) == track.at(seconds)); // it is for what is made of the picture
            QVERIFY(row.get(scene.atFrame(0).effect()) == row.get(effect));
        } else if (interpolates(row.kind)) {
            QVERIFY(!tests::sameBits(pictureOf(scene, kFrame).pixels, pictureOf(effect, kFrame).pixels));
        }
    }

    void aHeldKeyChangesNothingBeforeIt_data()
    {
        addAnimatedRows([](Animates when) { return when != Animates::Frame; });
    }
    void aHeldKeyChangesNothingBeforeIt()
    {
        QFETCH(QString, key);
        const Parameter& row = *findParameter(key.toStdString());
        if (&row == &knownParameter("camera.turntable") || &row == &knownParameter("emitter.inherit")
            || row.key.starts_with("emitter.parent_life")) {
            return; // no particle knows of it, where nothing moves the emitter, or is born on another
        }
        // How often swirls of the air and of its source become others goes by what is greatest; how many places there
        // are for particles, by how many there are ever.
        const bool goesByTheGreatest = row.key == "air.turbulence" || row.key == "air.turbulence_scale"
            || row.key == "air.buoyancy" || row.key == "emitter.rate";
        Effect effect = stageOf(row);
        if (row.dirties == DirtyStage::Shade) {
            effect.look.mask = MaskShape::Square; // that it turns is seen
        }
        const Scene scene =
            withTrack(effect, trackOf(row, {{0.0, row.get(effect), Ease::Hold}, {0.2, moved(row, effect)}}));
        if (row.dirties == DirtyStage::Shade) { // what is drawn turns, and no particle knows of it
            QVERIFY(sameFrame(*frameOfScene(scene, kFrame), *frameOfScene(effect, kFrame)));
            const float before = farthest(pictureOf(scene, 5), pictureOf(effect, 5));
            const float after = farthest(pictureOf(scene, kFrame), pictureOf(effect, kFrame));
            QVERIFY2(before < 1e-5F && after > 1e-4F, qPrintable(QString("%1 %2").arg(before).arg(after)));
            return;
        }
        if (row.animates == Animates::Rate && !goesByTheGreatest) {
            QVERIFY(nearFrame(*frameOfScene(scene, 5), *frameOfScene(effect, 5))); // sums are rounded
        } else if (!goesByTheGreatest) {
            QVERIFY(sameFrame(*frameOfScene(scene, 5), *frameOfScene(effect, 5)));
        }
        QVERIFY(!sameFrame(*frameOfScene(scene, kFrame), *frameOfScene(effect, kFrame)));
    }

    void anyFrameAloneIsThePlayedOne_data()
    {
        QTest::addColumn<bool>("air");
        QTest::addColumn<bool>("loop");
        QTest::newRow("closed forms") << false << false;
        QTest::newRow("closed forms, loop") << false << true;
        QTest::newRow("air") << true << false;
        QTest::newRow("air, loop") << true << true;
    }
    void anyFrameAloneIsThePlayedOne()
    {
        QFETCH(bool, air);
        QFETCH(bool, loop);
        Effect effect = everythingOn();
        effect.look.detail = 0.0F;
        effect.air.enabled = air;
        effect.air.resolution = kMinAirResolution;
        effect.air.obstacle = Obstacle::Sphere;
        effect.timeline.loop = loop;
        effect.timeline.length = 24;
        effect.timeline.prewarm = loop;
        effect.life.fadeRate = 0.2F;
        Scene scene = effect;
        for (const char* text :
            {"emitter.rate=0:0.2; 0.4:1; 0.8:0.2", "emitter.position=0:0,0.3,0; 0.4:0.3,0.5,0; 0.8:0,0.3,0",
                "emitter.normal=0:0,1,0; 0.4:1,1,0; 0.8:0,1,0", "motion.gravity=0:0.2; 0.4:3; 0.8:0.2",
                "wind.gust_rate=0:1; 0.4:5; 0.8:1", "source.surge_rate=0:1; 0.4:9; 0.8:1",
                "rings.speed=0:1; 0.4:4; 0.8:1", "turbulence.drift=0:1; 0.4:-2; 0.8:1",
                "turbulence.evolution=0:1; 0.4:3; 0.8:1",
                "air.obstacle_position=0:-0.5,1,0; 0.4:0.5,1.2,0; 0.8:-0.5,1,0",
                "air.obstacle_size=0:0.3,0.3,0.3; 0.4:0.5,0.3,0.3; 0.8:0.3,0.3,0.3", "look.spin=0:0; 0.4:400; 0.8:0",
                "look.texture_rate=0:0; 0.4:9; 0.8:0", "source.expansion=0:0; 0.4:8; 0.8:0",
                "air.turbulence=0:0; 0.4:2; 0.8:0", "camera.turntable=0:0; 0.8:90", "look.size=0:0.5; 0.8:0.9",
                "glow.emission=0:0; 0.4:3:hold; 0.6:1"}) {
            const Result<bool> clamped = animateScene(scene, text);
            QVERIFY2(clamped.ok(), clamped ? "" : clamped.error().text().c_str());
        }
        SceneRenderer played(scene);
        Image there;
        for (int frame = 0; frame < 18; ++frame) {
            const Status status = played.render(frame, 96, 96, there);
            QVERIFY2(status.ok(), status ? "" : status.error().text().c_str());
            if (frame == 5 || frame == 11 || frame == 17) {
                QVERIFY(tests::sameBits(there.pixels, pictureOf(scene, frame).pixels));
            }
        }
        if (loop) {
            QVERIFY(tests::sameBits(pictureOf(scene, 3).pixels, pictureOf(scene, 3 + 24).pixels));
        }
    }

    void birthsUnderARampAreQuadratic()
    {
        constexpr int kCount = 40000;
        const Effect effect = dots(kCount); // they live 5 s
        const Scene scene = withTrack(effect, trackOf(kRate, {{0.0, 0.0F, Ease::Linear}, {2.0, 1.0F}}));
        for (const int frame : {1, 7, 30, 60}) {
            const double seconds = frame / 30.0;
            const double expected = kCount / 5.0 * seconds * seconds / 4.0;
            QVERIFY(near(livingCount(*frameOfScene(scene, frame)), expected, 1.0));
        }
        // Then as many as ever, and all of them once those of the ramp have died.
        QVERIFY(near(livingCount(*frameOfScene(scene, 90)), kCount / 5.0 * 2.0, 1.0));
        QVERIFY(near(livingCount(*frameOfScene(scene, 240)), kCount, 1.0));
    }

    void anEmissionThatEndsLeavesNobody()
    {
        const Scene scene = withTrack(dots(5000), trackOf(kRate, {{0.0, 1.0F, Ease::Hold}, {1.0, 0.0F}}));
        constexpr double kBorn = 5000.0 / 150.0 * 31.0; // in frames 0 to 30
        QVERIFY(near(livingCount(*frameOfScene(scene, 30)), kBorn, 1.0));
        QVERIFY(near(livingCount(*frameOfScene(scene, 100)), kBorn, 1.0));
        QCOMPARE(livingCount(*frameOfScene(scene, 181)), 0);
        const Scene never = withTrack(dots(5000), trackOf(kRate, {{0.0, 0.0F}}));
        QCOMPARE(livingCount(*frameOfScene(never, 60)), 0);
    }

    void noMoreLiveThanThereArePlaces()
    {
        for (const bool loop : {false, true}) {
            Effect effect = dots(3000);
            effect.timeline.loop = loop;
            effect.timeline.length = 40;
            effect.life.fadeRate = 0.1F;
            Track track = trackOf(kRate, {{0.0, 0.1F}, {0.3, 1.0F}, {0.7, 0.0F}, {1.2, 0.8F}});
            track.after = Extrapolation::Loop;
            const SampledEffect whole = sampled(effect, withTrack(effect, track).allTracks(0));
            const Schedule schedule = makeSchedule(whole);
            for (std::int64_t step = 0; step < 2000; ++step) {
                const std::int64_t alive = schedule.birthsBefore(step + 1) - schedule.firstAlive(step);
                QVERIFY(alive >= 0 && alive <= schedule.capacity());
                QVERIFY(schedule.birthsBefore(step + 1) >= schedule.birthsBefore(step));
            }
        }
    }

    void particlesAreBornOnTheWayOfTheEmitter()
    {
        Effect effect = dots(6000);
        effect.emitter.subframe = true;
        const Scene scene = withTrack(effect,
            trackOf(knownParameter("emitter.position"),
                {{0.0, glm::vec3(0.0F), Ease::Linear}, {1.0, glm::vec3(3.0F, 0.0F, 1.5F)}}));
        const std::shared_ptr<const Frame> frame = frameOfScene(scene, 24);
        int seen = 0;
        for (std::size_t i = 0; i < frame->particles.capacity; ++i) {
            const Lifecycle cycle = lifecycle(*frame, i);
            if (cycle.alive) {
                const double born = std::max(0.0, 24.0 / 30.0 - static_cast<double>(cycle.age));
                QVERIFY(near(static_cast<double>(frame->particles.x[i]), 3.0 * born, 1e-4));
                QVERIFY(near(static_cast<double>(frame->particles.z[i]), 1.5 * born, 1e-4));
                ++seen;
            }
        }
        QVERIFY(seen > 900);
    }

    void aHeldPlaceIsJumpedTo()
    {
        Effect effect = dots(6000);
        effect.emitter.subframe = true;
        const Scene scene = withTrack(effect,
            trackOf(knownParameter("emitter.position"),
                {{0.0, glm::vec3(0.0F), Ease::Hold}, {0.5, glm::vec3(3.0F, 0.0F, 0.0F)}}));
        const std::shared_ptr<const Frame> frame = frameOfScene(scene, 24);
        for (std::size_t i = 0; i < frame->particles.capacity; ++i) {
            const float x = frame->particles.x[i];
            QVERIFY(!lifecycle(*frame, i).alive || x == 0.0F || x == 3.0F); // none lies between
        }
    }

    void velocityIsTheIntegralOfKeyedGravity()
    {
        Effect effect = dots(500);
        const Scene scene =
            withTrack(effect, trackOf(knownParameter("motion.gravity"), {{0.0, 9.0F, Ease::Linear}, {1.0, 0.0F}}));
        const std::shared_ptr<const Frame> frame = frameOfScene(scene, 45);
        double oldest = 0.0;
        double speed = 0.0;
        for (std::size_t i = 0; i < frame->particles.capacity; ++i) {
            const Lifecycle cycle = lifecycle(*frame, i);
            if (cycle.alive && static_cast<double>(cycle.age) > oldest) {
                oldest = static_cast<double>(cycle.age);
                speed = static_cast<double>(frame->particles.vy[i]);
            }
        }
        const double from = 1.5 - oldest;
        const double expected = -9.0 * ((1.0 - 0.5) - (from - 0.5 * from * from));
        QVERIFY(near(speed, expected, 9.0 / 30.0)); // within what a step adds
        QVERIFY(speed < -4.0);
    }

    void aRateHasNoJumpWhereItChanges()
    {
        Effect effect = everythingOn();
        const Track track = trackOf(knownParameter("wind.gust_rate"), {{0.0, 0.5F, Ease::Hold}, {1.0, 6.0F}});
        const Schedule schedule = makeSchedule(sampled(effect));
        const RateSum sum(track, schedule, effect.timeline);
        for (double step = 0.0; step < 400.0; step += 0.25) {
            const double way = sum.at(step + 0.25) - sum.at(step);
            QVERIFY(way > 0.0 && way <= 0.25 * 6.0 / 30.0 + 1e-6);
        }
    }

    void layersHaveTracksOfTheirOwn()
    {
        Scene scene = everythingOn();
        scene.layers[0].name = "smoke";
        scene.layers.push_back(scene.layers[0]);
        scene.layers[1].name = "embers";
        scene.layers[1].emitter.seed = 8;
        const SceneFrame before = SceneSimulator(sampledLayers(scene)).frame(kFrame).value();
        QVERIFY(animateScene(scene, "embers/motion.gravity=0:0; 0.2:9").ok());
        const SceneFrame after = SceneSimulator(sampledLayers(scene)).frame(kFrame).value();
        QVERIFY(sameFrame(*before.layers[0], *after.layers[0]));
        QVERIFY(!sameFrame(*before.layers[1], *after.layers[1]));
        QVERIFY(animateScene(scene, "embers/motion.gravity=").ok());
        QVERIFY(scene.layers[1].tracks.empty());
    }

    void filesKeepTracks()
    {
        Scene scene = everythingOn();
        QVERIFY(animateScene(scene, "glow.emission=0:1; 0.033333333333333333:2:hold; 2:0; after=ping-pong").ok());
        QVERIFY(animateScene(scene, "light.colour=0:1,0,0; 1:0,0,1:linear; before=loop").ok());
        QVERIFY(animateScene(scene, "output.background=0:transparent; 1:colour").ok());
        Track free = trackOf(knownParameter("emitter.position"),
            {{0.1, glm::vec3(1.0F), Ease::Free, glm::vec3(0.25F), glm::vec3(-3.0F, 2.0F, 1.0F)},
                {0.7, glm::vec3(2.0F)}});
        scene.layers[0].tracks.set(free);
        Track arrived = trackOf(kRate, {{0.0, 0.0F}, {0.5, 1.0F, Ease::Hold}, {1.0, 0.5F, Ease::Linear}});
        arrived.keys[1].slopeIn.x = 0.75F;
        arrived.keys[1].ownArrival = true;
        scene.layers[0].tracks.set(arrived);
        const Result<PresetReading> reading = parsePreset(textOf(scene), "here.json");
        QVERIFY2(reading.ok(), reading ? "" : reading.error().text().c_str());
        QVERIFY(reading.value().preset.scene == scene);
        QVERIFY(reading.value().warnings.empty());
    }

    void unknownTracksAreKept()
    {
        std::string text = textOf(Scene(everythingOn()));
        const std::string track = R"({"key": "glow.sparkle", "keys": [[0, 1], [1, 2]]})";
        text.insert(text.find("\"name\": \"\",\n      \"visible\""), "\"animation\": [" + track + "],\n      ");
        const Result<PresetReading> reading = parsePreset(text, "here.json");
        QVERIFY2(reading.ok(), reading ? "" : reading.error().text().c_str());
        QCOMPARE(reading.value().warnings.size(), std::size_t{1});
        QVERIFY(formatPreset(reading.value().preset).find(track) != std::string::npos);
    }

    void brokenTracksAreRefused_data()
    {
        QTest::addColumn<QString>("animation");
        QTest::addColumn<QString>("says");
        const auto rate = [](const char* keys) {
            return QStringLiteral(R"([{"key": "emitter.rate", "keys": %1}])").arg(QLatin1String(keys));
        };
        QTest::newRow("no list") << QStringLiteral("{}") << "list";
        QTest::newRow("no key") << QStringLiteral(R"([{"keys": [[0, 1]]}])") << "\"key\"";
        QTest::newRow("unsorted") << rate("[[1, 1], [0, 0]]") << "emitter.rate: the key frame at 0 s";
        QTest::newRow("two at one time") << rate("[[1, 1], [1, 0]]") << "the key frame at 1 s";
        QTest::newRow("none") << rate("[]") << "0 key frames";
        QTest::newRow("no value") << rate("[[1]]") << "key frame is a list";
        QTest::newRow("another kind") << rate("[[1, \"high\"]]") << "expected";
        QTest::newRow("no number") << rate("[[1e999, 1]]") << "";
        QTest::newRow("far") << rate("[[1e300, 1]]") << "away";
        QTest::newRow("unknown ease") << rate("[[0, 1, \"bounce\"]]") << "auto";
        QTest::newRow("slopes of none") << rate("[[0, 1, \"auto\", 1, 1]]") << "slopes";
        QTest::newRow("two slopes of a held one") << rate("[[0, 1, \"hold\", 1, 1]]") << "slopes";
        QTest::newRow("one slope of a free one") << rate("[[0, 1, \"free\", 1]]") << "slopes";
        QTest::newRow("one slope of a smooth one") << rate("[[0, 1, \"auto\", 1]]") << "slopes";
        QTest::newRow("no slope") << rate("[[0, 1, \"linear\", \"steep\"]]") << "a slope is a number";
        QTest::newRow("cannot change") << QStringLiteral(R"([{"key": "emitter.seed", "keys": [[0, 1]]}])")
                                       << "emitter.seed: this parameter cannot change";
        QTest::newRow("twice") << QStringLiteral(
            R"([{"key": "emitter.rate", "keys": [[0, 1]]}, {"key": "emitter.rate", "keys": [[0, 1]]}])")
                               << "second track";
        QString many = QStringLiteral("[[0, 0]");
        for (int key = 1; key <= static_cast<int>(kMaxKeyFrames); ++key) {
            many += QStringLiteral(", [%1, 0]").arg(key);
        }
        QTest::newRow("too many") << rate(qPrintable(many + QLatin1Char(']'))) << "10001 key frames";
    }
    void brokenTracksAreRefused()
    {
        QFETCH(QString, animation);
        QFETCH(QString, says);
        std::string text = textOf(Scene(everythingOn()));
        text.insert(
            text.find("\"name\": \"\",\n      \"visible\""), "\"animation\": " + animation.toStdString() + ",\n      ");
        const Result<PresetReading> reading = parsePreset(text, "here.json");
        QVERIFY(!reading);
        const std::string said = reading.error().text();
        QVERIFY2(said.find("here.json, line ") != std::string::npos, said.c_str());
        QVERIFY2(said.find(says.toStdString()) != std::string::npos, said.c_str());
    }

    void wordsOfTheCommandLine_data()
    {
        QTest::addColumn<QString>("text");
        QTest::newRow("no such parameter") << "emiter.rate=0:1";
        QTest::newRow("cannot change") << "emitter.seed=0:1";
        QTest::newRow("no value") << "emitter.rate=0";
        QTest::newRow("no number") << "emitter.rate=0:nan";
        QTest::newRow("time") << "emitter.rate=inf:1";
        QTest::newRow("ease") << "emitter.rate=0:1:free";
        QTest::newRow("outside") << "emitter.rate=0:1; after=bounce";
        QTest::newRow("no layer") << "embers/emitter.rate=0:1";
        QString many = QStringLiteral("emitter.rate=0:1");
        for (int key = 1; key < 100'000; ++key) {
            many += QStringLiteral(";%1:1").arg(key);
        }
        QTest::newRow("more than there may be") << many;
        QTest::newRow("nothing, a million times")
            << QStringLiteral("emitter.rate=0:1") + QString(1'000'000, QLatin1Char(';'));
    }
    void wordsOfTheCommandLine()
    {
        QFETCH(QString, text);
        Scene scene = everythingOn();
        const Scene before = scene;
        QVERIFY(!animateScene(scene, text.toStdString()));
        QVERIFY(scene == before);
    }
};

QTEST_GUILESS_MAIN(AnimationTest)
#include "animation_test.moc"
