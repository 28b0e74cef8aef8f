#include "tests/helpers.h"

#include "core/effect/known_parameter.h"
#include "core/preset/preset_file.h"
#include "core/scene/layer_assignment.h"
#include "core/simulation/scene_simulator.h"

#include <algorithm>
#include <cmath>

using namespace fumage;

namespace {

constexpr float kSpeed = 2.0F;
constexpr int kFrame = 20;

/// A point from which particles fly straight up, with nothing that moves them otherwise.
Effect flyer()
{
    Effect effect;
    effect.emitter.radius = 0.0F;
    effect.emitter.speed = kSpeed;
    effect.emitter.velocityRandomness = 0.0F;
    effect.emitter.spread = 0.0F;
    effect.motion = {};
    effect.motion.drag = 0.0F;
    effect.motion.buoyancy = 0.0F;
    effect.motion.pull = 0.0F;
    effect.wind.strength = 0.0F;
    effect.turbulence.strength = 0.0F;
    effect.rings.strength = 0.0F;
    effect.life.fadeRate = 0.25F;
    effect.life.initialAlpha = 1.0F;
    effect.timeline.prewarm = false;
    effect.timeline.length = 40;
    return effect;
}

/// One rocket from a burst, and the trail that it leaves.
Scene rocketWithTrail()
{
    Scene scene = flyer();
    scene.layers[0].name = "rocket";
    scene.layers[0].emitter.mode = EmissionMode::Burst;
    scene.layers[0].emitter.burstDuration = 0.0F;
    scene.layers[0].emitter.count = 1;
    scene.layers.push_back(scene.layers[0]);
    Layer& trail = scene.layers[1];
    trail.name = "trail";
    trail.from = "rocket";
    trail.emitter.mode = EmissionMode::Continuous;
    trail.emitter.speed = 0.0F;
    trail.emitter.count = 3000;
    trail.emitter.seed = 7;
    trail.emitter.position = {5.0F, 1.0F, 0.0F}; // not that it matters
    return scene;
}

/// Smoke in air, embers that are born on it, and sparks that are born on those.
Scene threeInAir(bool loop)
{
    Scene scene = tests::everythingOn();
    scene.air.enabled = true;
    scene.air.resolution = kMinAirResolution;
    scene.timeline.loop = loop;
    scene.timeline.length = 20;
    scene.layers[0].name = "smoke";
    scene.layers[0].life.lifetimeVariance = 0.5F;
    scene.layers.resize(3, scene.layers[0]);
    scene.layers[1].name = "embers";
    scene.layers[1].from = "smoke";
    scene.layers[1].emitter.seed = 5;
    scene.layers[1].emitter.inherit = 0.5F;
    scene.layers[1].motion.coupling = Coupling::Dragged;
    scene.layers[2].name = "sparks";
    scene.layers[2].from = "embers";
    scene.layers[2].emitter.seed = 9;
    scene.layers[2].life.fadeRate *= 2.0F;
    scene.layers[2].motion.coupling = Coupling::Free;
    return scene;
}

SceneFrame frameOf(const Scene& scene, int number)
{
    const Result<SceneFrame> frame = SceneSimulator(sampledLayers(scene)).frame(number);
    if (!frame) {
        qFatal("%s", frame.error().text().c_str());
    }
    return frame.value();
}

} // namespace

class BornOnTest : public QObject {
    Q_OBJECT

private slots:
    void moreParentsThanMemoryHoldsAreRefused()
    {
        Scene scene = flyer();
        scene.layers[0].name = "0";
        scene.layers[0].emitter.count = kMaxParticles;
        scene.layers.resize(12, scene.layers[0]);
        for (std::size_t layer = 1; layer < scene.layers.size(); ++layer) {
            scene.layers[layer].name = std::to_string(layer);
            scene.layers[layer].from = std::to_string(layer - 1);
        }
        const auto refused = SceneSimulator(sampledLayers(scene)).frame(0);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::TooLarge);
        for (Layer& layer : scene.layers) {
            layer.emitter.count = 10;
        }
        QVERIFY(SceneSimulator(sampledLayers(scene)).frame(0).ok());
    }

    void atWhichAgeChangesWithKeyFrames()
    {
        Scene scene = rocketWithTrail();
        const Parameter& row = knownParameter("emitter.parent_life_to");
        scene.layers[1].tracks.set(Track{&row, {{0.0, 1.0F, Ease::Hold}, {0.4, 0.0F}}});
        const std::shared_ptr<const Frame> trail = frameOf(scene, kFrame).layers[1];
        int seen = 0;
        for (std::size_t i = 0; i < trail->particles.capacity; ++i) {
            const Lifecycle cycle = lifecycle(*trail, i);
            if (cycle.alive) {
                QVERIFY(cycle.age > 0.299F); // the last before 0.4 s: at step 11 of 20
                ++seen;
            }
        }
        QVERIFY(seen > 100);
    }

    /// Where it was born on a rocket that flies straight on, and what it took along: y = v (t - age) + share v age.
    void aTrailLiesOnTheWay_data()
    {
        QTest::addColumn<float>("share");
        QTest::addColumn<bool>("subframe");
        QTest::newRow("left behind") << 0.0F << true;
        QTest::newRow("half") << 0.5F << true;
        QTest::newRow("goes on with it") << 1.0F << true;
        QTest::newRow("backwards") << -0.5F << true;
        QTest::newRow("at steps") << 0.0F << false;
    }
    void aTrailLiesOnTheWay()
    {
        QFETCH(float, share);
        QFETCH(bool, subframe);
        Scene scene = rocketWithTrail();
        scene.layers[0].emitter.subframe = subframe;
        scene.layers[1].emitter.subframe = subframe;
        scene.layers[1].emitter.inherit = share;
        const SceneFrame frame = frameOf(scene, kFrame);
        const Frame& rocket = *frame.layers[0];
        const Frame& trail = *frame.layers[1];
        const float now = lifecycle(rocket, 0).age;
        QVERIFY(tests::near(rocket.particles.y[0], kSpeed * now, 1e-5));
        float lowest = 1e9F;
        float highest = -1e9F;
        for (std::size_t slot = 0; slot < trail.particles.capacity; ++slot) {
            const Lifecycle cycle = lifecycle(trail, slot);
            if (!cycle.alive) {
                continue;
            }
            const float y = trail.particles.y[slot];
            // Who is born in the step of the rocket's own birth is born with it at the earliest.
            const float age = std::min(cycle.age, now);
            const float tolerance = cycle.age > now ? kSpeed / 30.0F : 1e-4F;
            QVERIFY(tests::near(y, kSpeed * (now - age) + share * kSpeed * age, tolerance));
            QVERIFY(tests::near(trail.particles.x[slot], 0.0, 1e-5));
            lowest = std::min(lowest, y);
            highest = std::max(highest, y);
        }
        QVERIFY(tests::livingCount(trail) > 100);
        QVERIFY(share == 1.0F || highest - lowest > 0.4F * kSpeed * now);
    }

    /// At a share of the rocket's life, and so at a height: y = v age where the trail stays where it was left.
    void theParentsAgeDecides_data()
    {
        QTest::addColumn<float>("from");
        QTest::addColumn<float>("to");
        QTest::newRow("young") << 0.0F << 0.2F;
        QTest::newRow("grown") << 0.25F << 0.5F;
        QTest::newRow("at its death") << 0.9F << 1.0F;
        QTest::newRow("the other way round") << 0.5F << 0.25F;
    }
    void theParentsAgeDecides()
    {
        QFETCH(float, from);
        QFETCH(float, to);
        constexpr float kLife = 0.5F; // s: it is over at frame 20
        Scene scene = rocketWithTrail();
        scene.layers[0].life.fadeRate = 1.0F / kLife;
        scene.layers[1].emitter.parentLifeFrom = from;
        scene.layers[1].emitter.parentLifeTo = to;
        const SceneFrame frame = frameOf(scene, kFrame);
        const Frame& trail = *frame.layers[1];
        const auto [young, old] = std::minmax(from, to);
        float lowest = 1e9F;
        float highest = -1e9F;
        for (std::size_t slot = 0; slot < trail.particles.capacity; ++slot) {
            if (lifecycle(trail, slot).alive) {
                lowest = std::min(lowest, trail.particles.y[slot]);
                highest = std::max(highest, trail.particles.y[slot]);
            }
        }
        QVERIFY(tests::livingCount(trail) > 20);
        constexpr float kStep = kSpeed / 30.0F; // a rocket's way in a step
        QVERIFY(lowest >= young * kLife * kSpeed - kStep && lowest <= young * kLife * kSpeed + kStep);
        QVERIFY(highest <= old * kLife * kSpeed + kStep && highest >= old * kLife * kSpeed - 2.0F * kStep);
    }

    /// Each particle takes along what is set at its birth.
    void whatIsTakenAlongHasKeyFrames()
    {
        constexpr const Parameter& kInherit = knownParameter("emitter.inherit");
        constexpr float kShare = 0.8F;
        constexpr double kSwitch = 0.34;
        Scene scene = rocketWithTrail();
        const Scene still = scene;
        scene.layers[1].emitter.inherit = kShare;
        const Scene moving = scene;
        Track track{&kInherit, {}};
        setKey(track, {0.0, 0.0F, Ease::Hold});
        setKey(track, {kSwitch, kShare, Ease::Hold});
        scene.tracksOf(kInherit, 1).set(track);
        const SceneFrame mixed = frameOf(scene, kFrame);
        const SceneFrame before = frameOf(still, kFrame);
        const SceneFrame after = frameOf(moving, kFrame);
        int changed = 0;
        const Particles& all = mixed.layers[1]->particles;
        for (std::size_t slot = 0; slot < all.capacity; ++slot) {
            if (lifecycle(*mixed.layers[1], slot).alive) {
                const bool isLate = all.birthStep[slot] >= static_cast<std::int32_t>(mixed.layers[1]->step) - 9;
                QCOMPARE(all.y[slot], (isLate ? after : before).layers[1]->particles.y[slot]);
                changed += isLate ? 1 : 0;
            }
        }
        QVERIFY(changed > 100 && changed < tests::livingCount(*mixed.layers[1]));
    }

    void anyFrameAloneIsThatWhichIsPlayed_data()
    {
        QTest::addColumn<bool>("loop");
        QTest::newRow("once") << false;
        QTest::newRow("loop") << true;
    }
    void anyFrameAloneIsThatWhichIsPlayed()
    {
        QFETCH(bool, loop);
        const Scene scene = threeInAir(loop);
        SceneSimulator played(sampledLayers(scene));
        for (const int number : {0, 1, 5, 6, 19, 12, 18}) {
            const SceneFrame inTurn = played.frame(number).value();
            const SceneFrame alone = frameOf(scene, number);
            for (std::size_t layer = 0; layer < 3; ++layer) {
                QVERIFY(tests::sameBits(inTurn.layers[layer]->particles, alone.layers[layer]->particles));
            }
        }
        QVERIFY(tests::livingCount(*frameOf(scene, 12).layers[2]) > 20);
    }

    /// In a loop the parent is warm, so that its end goes over into its beginning.
    void loopsClose()
    {
        const Scene scene = threeInAir(true);
        const std::vector<SampledEffect> layers = sampledLayers(scene);
        const SceneSimulator simulator(layers);
        for (std::size_t layer = 1; layer < 3; ++layer) {
            const SimulationModel& model = simulator.model(layer);
            Particles here;
            Particles later;
            SubEmitter parents(model);
            const std::int64_t step = model.schedule().stepOfFrame(7);
            QVERIFY(advanceFromNothing(model, here, step, &parents, {}));
            QVERIFY(advanceFromNothing(model, later, step + model.schedule().loopSteps, &parents, {}));
            const auto sorted = [](const Particles& particles) {
                std::vector<std::array<float, 3>> out;
                for (std::size_t i = 0; i < particles.capacity; ++i) {
                    out.push_back({particles.x[i], particles.y[i], particles.z[i]});
                }
                std::sort(out.begin(), out.end());
                return out;
            };
            QCOMPARE(sorted(here), sorted(later));
        }
    }

    void nothingIsBornOnWhatIsNotThere()
    {
        Scene scene = rocketWithTrail();
        scene.layers[0].emitter.start = 0.5F;
        QCOMPARE(tests::livingCount(*frameOf(scene, 10).layers[1]), 0);
        QVERIFY(tests::livingCount(*frameOf(scene, 25).layers[1]) > 0);
    }

    /// A parent that is not seen is one; neither quality nor previews change where its children are.
    void theParentStaysAsItIs()
    {
        Scene scene = rocketWithTrail();
        scene.layers[0].emitter.count = 9;
        scene.layers[0].emitter.spread = 180.0F;
        const SceneFrame seen = frameOf(scene, kFrame);
        for (const Quality quality : {Quality::Draft, Quality::Good, Quality::Final}) {
            scene.output.quality = quality;
            std::vector<SampledEffect> layers = sampledLayers(scene);
            QCOMPARE(layers[0]->emitter.count, 9);
            thinLayers(layers, 100);
            QCOMPARE(layers[0]->emitter.count, 9);
            QVERIFY(layers[1]->emitter.count <= 100);
            QVERIFY(*layers[1].parent() == layers[0]);
        }
        scene.output.quality = Quality::Good;
        scene.layers[0].visible = false;
        const SceneFrame muted = frameOf(scene, kFrame);
        QCOMPARE(muted.layers.size(), std::size_t{1});
        QVERIFY(tests::sameBits(muted.layers[0]->particles, seen.layers[1]->particles));
    }

    /// A change of the parent is one of its children, a change of its look is not.
    void childrenFollowTheirParent()
    {
        Scene scene = rocketWithTrail();
        SceneSimulator before(sampledLayers(scene));
        const SceneFrame first = before.frame(kFrame).value();
        scene.layers[0].look.opacity = 0.3F;
        SceneSimulator looks(sampledLayers(scene));
        looks.adopt(before);
        QCOMPARE(looks.frame(kFrame).value().layers[1].get(), first.layers[1].get());
        scene.layers[0].emitter.speed = 1.0F;
        SceneSimulator slower(sampledLayers(scene));
        slower.adopt(looks);
        const SceneFrame second = slower.frame(kFrame).value();
        QVERIFY(tests::sameBits(second.layers[1]->particles, frameOf(scene, kFrame).layers[1]->particles));
        QVERIFY(!tests::sameBits(second.layers[1]->particles, first.layers[1]->particles));
    }

    void filesKeepTheParent()
    {
        Preset preset;
        preset.scene = rocketWithTrail();
        const std::string text = formatPreset(preset);
        const Result<PresetReading> read = parsePreset(text);
        QVERIFY2(read.ok(), read ? "" : read.error().text().c_str());
        QVERIFY(read.value().warnings.empty());
        QVERIFY(read.value().preset.scene == preset.scene);
    }

    void whatCannotBeIsRefused_data()
    {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("said");
        QTest::newRow("nobody") << "rain"
                                << "no one layer";
        QTest::newRow("itself") << "rocket"
                                << "born on itself";
        QTest::newRow("a ring") << "trail"
                                << "born on itself";
        QTest::newRow("two of the name") << "twin"
                                         << "no one layer";
    }
    void whatCannotBeIsRefused()
    {
        QFETCH(QString, from);
        QFETCH(QString, said);
        Preset preset;
        preset.scene = rocketWithTrail();
        preset.scene.layers.resize(4, preset.scene.layers[1]);
        preset.scene.layers[2].name = "twin";
        preset.scene.layers[3].name = "twin";
        Scene kept = preset.scene;
        const Result<bool> set = applyToScene(kept, "rocket/from=" + from.toStdString());
        QVERIFY(!set && QString::fromStdString(set.error().text()).contains(said));
        QVERIFY(kept == preset.scene);
        preset.scene.layers[0].from = from.toStdString();
        const Result<PresetReading> read = parsePreset(formatPreset(preset));
        QVERIFY(!read.ok());
        QVERIFY2(QString::fromStdString(read.error().text()).contains(said), read.error().text().c_str());
        QVERIFY(QString::fromStdString(read.error().text()).contains(QStringLiteral("line")));
        QVERIFY(frameOf(preset.scene, 3).layers.size() == 4); // and does no harm where nobody has asked
    }

    void assignmentsNameTheParent()
    {
        Scene scene = rocketWithTrail();
        QVERIFY(applyToScene(scene, "trail/from=").ok());
        QVERIFY(scene.layers[1].from.empty());
        QVERIFY(applyToScene(scene, "2/from= rocket ").ok());
        QVERIFY(scene == rocketWithTrail());
        QVERIFY(applyToScene(scene, "Trail/from=Rocket").ok()); // the name is kept as the layer has it
        QVERIFY(scene == rocketWithTrail());
        scene.layers.push_back(scene.layers[0]);
        scene.layers[2].name = "ROCKET";
        const Result<bool> either = applyToScene(scene, "trail/from=Rocket");
        QVERIFY(!either && QString::fromStdString(either.error().text()).contains("\"rocket\" (1), \"ROCKET\" (3)"));
        QVERIFY(applyToScene(scene, "trail/from=ROCKET").ok());
        QCOMPARE(scene.layers[1].from, std::string("ROCKET"));
    }
};

QTEST_GUILESS_MAIN(BornOnTest)
#include "born_on_test.moc"
