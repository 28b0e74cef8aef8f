// What moves particles and changes over time: turbulence that drifts and becomes another, obstacles that move.

#include "tests/helpers.h"
#include "tests/simulation/flying.h"

#include "core/base/hash.h"
#include "core/effect/known_parameter.h"
#include "core/live/live_scene.h"
#include "core/scene/key_assignment.h"
#include "core/simulation/air_cache.h"
#include "core/simulation/step.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr double kFrameRate = 30.0;

Effect turbulent()
{
    Effect effect = thesisEffect(1);
    effect.turbulence.strength = 1.0F;
    effect.turbulence.scale = 0.3F;
    effect.turbulence.octaves = 3;
    effect.turbulence.growth = 0.0F;
    effect.turbulence.onset = 0.0F;
    effect.turbulence.drift = 0.0F;
    effect.turbulence.evolution = 0.0F;
    return effect;
}

Tracks trackOf(const Parameter& row, std::vector<KeyFrame> keys)
{
    Tracks tracks;
    tracks.set(Track{&row, std::move(keys)});
    return tracks;
}

/// Upward velocity of turbulence at many places, of which all are as much higher.
std::vector<float> upwards(const SimulationModel& model, std::int64_t step, double higher = 0.0)
{
    std::vector<float> x(3000);
    std::vector<float> y(x.size());
    std::vector<float> z(x.size());
    for (std::uint32_t i = 0; i < x.size(); ++i) {
        x[i] = 9.0F * signedFloat(mixBits(3 * i));
        y[i] = 9.0F * signedFloat(mixBits(3 * i + 1)) + static_cast<float>(higher);
        z[i] = 9.0F * signedFloat(mixBits(3 * i + 2));
    }
    std::vector<float> u(x);
    std::vector<float> v(x);
    std::vector<float> w(x);
    turbulenceAt(model.constants(step), x, y, z, u, v, w);
    return v;
}

/// Particles that hang in the air, which nothing moves.
Effect hanging(Coupling coupling)
{
    Effect effect = flying(coupling);
    effect.emitter.speed = 0.0F;
    effect.motion.restitution = 0.5F;
    effect.motion.friction = 0.0F;
    effect.air.obstacleSize = glm::vec3(1.0F);
    return effect;
}

/// An obstacle that comes from the left, at a speed in m/s.
Tracks comingAt(float speed)
{
    return trackOf(knownParameter("air.obstacle_position"),
        {{0.0, glm::vec3(-2.0F, 2.0F, 0.0F), Ease::Linear}, {4.0, glm::vec3(-2.0F + 4.0F * speed, 2.0F, 0.0F)}});
}

/// Particles that are born in one point, between steps, and stay there.
Effect pointAtRest()
{
    Effect effect = thesisEffect(6000);
    effect.emitter.width = 0.0F;
    effect.emitter.depth = 0.0F;
    effect.emitter.speed = 0.0F;
    effect.emitter.subframe = true;
    return effect;
}

} // namespace

class KeyedMotionTest : public QObject {
    Q_OBJECT

private slots:
    void swirlsRiseByTheIntegralOfTheirDrift()
    {
        const Tracks ramp = trackOf(knownParameter("turbulence.drift"), {{0.0, 0.0F, Ease::Linear}, {4.0, 6.0F}});
        const SimulationModel model(sampled(turbulent(), ramp));
        const std::vector<float> before = upwards(model, 0);
        for (const int step : {20, 40, 90}) {
            const double seconds = step / kFrameRate;
            const double risen = 0.5 * 6.0 / 4.0 * seconds * seconds;
            QVERIFY(correlation(before, upwards(model, step, risen)) > 0.999);
            QVERIFY(correlation(before, upwards(model, step)) < 0.5);
        }
    }

    void aPhaseGoesOnWhereADriftJumps()
    {
        Effect effect = turbulent();
        effect.turbulence.evolution = 0.1F;
        const Tracks held = trackOf(knownParameter("turbulence.drift"), {{0.0, 1.0F, Ease::Hold}, {1.0, -3.0F}});
        const SimulationModel model(sampled(effect, held));
        for (int step = 25; step < 35; ++step) {
            const double risen = (step < 30 ? 1.0 : -3.0) / kFrameRate;
            QVERIFY(correlation(upwards(model, step), upwards(model, step + 1, risen)) > 0.98);
        }
    }

    void evolutionThatBeginsLateIsThatOfAnEarlierOne()
    {
        Effect effect = turbulent();
        const Tracks held = trackOf(knownParameter("turbulence.evolution"), {{0.0, 0.0F, Ease::Hold}, {1.0, 2.0F}});
        const SimulationModel late(sampled(effect, held));
        effect.turbulence.evolution = 2.0F;
        const SimulationModel constant(sampled(effect));
        for (const int step : {0, 5, 31, 77}) {
            QVERIFY(correlation(upwards(constant, step), upwards(late, step + 30)) > 0.9999);
        }
        QVERIFY(correlation(upwards(late, 3), upwards(late, 29)) > 0.9999); // until then nothing changes
        QVERIFY(correlation(upwards(late, 30), upwards(late, 60)) < 0.5);
    }

    void aLoopOfKeyedTurbulenceCloses()
    {
        Effect effect = turbulent();
        effect.turbulence.evolution = 0.5F;
        effect.timeline.loop = true;
        effect.timeline.length = 45;
        Tracks tracks =
            trackOf(knownParameter("turbulence.drift"), {{0.0, -1.0F}, {0.7, 2.0F}, {1.5, -1.0F}}); // about none in all
        tracks.add(trackOf(knownParameter("turbulence.evolution"), {{0.0, 0.0F}, {0.7, 3.0F}, {1.5, 0.0F}}));
        const SimulationModel model(sampled(effect, tracks));
        const std::int64_t start = 2 * model.schedule().loopSteps;
        QVERIFY(upwards(model, start + 3) == upwards(model, start + 3 + model.schedule().loopSteps));
        for (std::int64_t step = start - 2; step < start + 2; ++step) {
            QVERIFY(correlation(upwards(model, step), upwards(model, step + 1)) > 0.6); // a jump would leave none
        }
    }

    void turbulenceWhoseRatesAreSetGoesOnFromWhereItIs()
    {
        Effect effect = turbulent();
        effect.turbulence.drift = 0.4F;
        effect.turbulence.evolution = 0.1F;
        const SimulationModel before(sampled(effect));
        SimulationModel same(sampled(effect));
        same.continueFrom(before, 50);
        QVERIFY(upwards(same, 60) == upwards(before, 60));
        effect.turbulence.drift = 5.0F;
        effect.turbulence.evolution = 0.2F;
        SimulationModel after(sampled(effect));
        after.continueFrom(before, 50);
        QVERIFY(correlation(upwards(before, 50), upwards(after, 50)) > 0.9999);
        QVERIFY(correlation(upwards(before, 50), upwards(after, 52, 5.0 * 2.0 / kFrameRate)) > 0.95);
        QVERIFY(correlation(upwards(before, 50), upwards(SimulationModel(sampled(effect)), 50)) < 0.9);
    }

    void whatAWallHitsBouncesOffAsItMoves_data()
    {
        QTest::addColumn<int>("obstacle");
        QTest::newRow("box") << static_cast<int>(Obstacle::Box);
        QTest::newRow("ball") << static_cast<int>(Obstacle::Sphere);
    }
    void whatAWallHitsBouncesOffAsItMoves()
    {
        QFETCH(int, obstacle);
        constexpr float kSpeed = 3.0F;
        Effect effect = hanging(Coupling::Free);
        effect.air.obstacle = static_cast<Obstacle>(obstacle);
        Simulator simulator(sampled(effect, comingAt(kSpeed)));
        const auto frame = simulator.frame(20).value();
        const Particles& p = frame->particles;
        int touched = 0;
        for (std::size_t i = 0; i < p.capacity; ++i) {
            const glm::dvec3 v(p.vx[i], p.vy[i], p.vz[i]);
            if (p.birthStep[i] == Particles::kUnborn || glm::length(v) == 0.0) {
                continue;
            }
            // It was at rest: what it gets is along the surface's normal n, (1 + e) (V.n) n.
            const glm::dvec3 normal = glm::normalize(v);
            QVERIFY(near(glm::length(v), 1.5 * static_cast<double>(kSpeed) * normal.x, 1e-3));
            QVERIFY(obstacle != static_cast<int>(Obstacle::Box) || normal.x > 0.9999);
            ++touched;
        }
        QVERIFY(touched > 100);
        Simulator still(sampled(effect));
        const auto beside = still.frame(20).value();
        QVERIFY(
            std::all_of(beside->particles.vx.begin(), beside->particles.vx.end(), [](float v) { return v == 0.0F; }));
    }

    void whatTheAirCarriesIsPushedAlong()
    {
        Effect effect = hanging(Coupling::Carried);
        effect.air.obstacle = Obstacle::Sphere;
        effect.air.fit = false;
        effect.air.size = glm::vec3(4.0F);
        effect.air.offset = {0.0F, -1.0F, 0.0F};
        const auto meanOf = [&](const Tracks& tracks) {
            Simulator simulator(sampled(effect, tracks));
            const auto frame = simulator.frame(20).value();
            double sum = 0.0;
            int count = 0;
            for (std::size_t i = 0; i < frame->particles.capacity; ++i) {
                if (frame->particles.birthStep[i] != Particles::kUnborn) {
                    sum += static_cast<double>(frame->particles.x[i]);
                    ++count;
                }
            }
            return sum / count;
        };
        const Tracks still = trackOf(knownParameter("air.obstacle_position"), {{0.0, glm::vec3(-2.0F, 2.0F, 0.0F)}});
        QVERIFY(meanOf(comingAt(2.0F)) > meanOf(still) + 0.04); // its front comes to -0.17
    }

    void nothingIsBornOnTheWayBackToTheFirstKey()
    {
        Effect effect = pointAtRest();
        Track way{&knownParameter("emitter.position"),
            {{0.0, glm::vec3(0.0F), Ease::Linear}, {1.0, glm::vec3(9.0F, 0.0F, 0.0F)}}};
        way.after = Extrapolation::Loop;
        Tracks tracks;
        tracks.set(way);
        Simulator simulator(sampled(effect, tracks));
        for (const int number : {31, 61, 91}) {
            const auto frame = simulator.frame(number).value();
            const Particles& p = frame->particles;
            int born = 0;
            for (std::size_t i = 0; i < p.capacity; ++i) {
                if (p.birthStep[i] == static_cast<std::int32_t>(frame->step)) {
                    QVERIFY(p.x[i] < 0.5F); // a step takes it 0.3 m far
                    ++born;
                }
            }
            QVERIFY(born > 20);
        }
    }

    void newbornsLieAlongTheWayThroughTheEndOfALoop()
    {
        Effect effect = pointAtRest();
        effect.timeline.loop = true;
        effect.timeline.length = 30;
        const glm::vec3 far(9.0F, 0.0F, 0.0F);
        const Tracks way = trackOf(knownParameter("emitter.position"),
            {{0.0, glm::vec3(0.0F), Ease::Linear}, {0.5, far, Ease::Linear}, {1.0, glm::vec3(0.0F)}});
        Simulator simulator(sampled(effect, way));
        const auto frame = simulator.frame(0).value();
        const Particles& p = frame->particles;
        float farthest = 0.0F;
        for (std::size_t i = 0; i < p.capacity; ++i) {
            farthest = p.birthStep[i] == static_cast<std::int32_t>(frame->step) ? std::max(farthest, p.x[i]) : farthest;
        }
        QVERIFY(farthest > 0.4F); // a step takes it 0.6 m far
        QVERIFY(farthest < 0.61F);
    }

    void newbornsLieEvenlyAlongTheWayInAirToo()
    {
        Effect effect = flying(Coupling::Carried);
        effect.emitter.count = 4000;
        effect.emitter.mode = EmissionMode::Continuous;
        effect.emitter.subframe = true;
        effect.emitter.speed = 0.0F;
        effect.emitter.radius = 0.001F;
        effect.life.initialAlpha = 1.0F;
        effect.life.fadeRate = 1.0F;
        effect.motion.gravity = 0.0F;
        const Tracks way = trackOf(knownParameter("emitter.position"),
            {{0.0, glm::vec3(0.0F), Ease::Linear}, {2.0, glm::vec3(12.0F, 0.0F, 0.0F)}});
        for (const bool air : {false, true}) {
            effect.air.enabled = air;
            Simulator simulator(sampled(effect, way));
            const auto frame = simulator.frame(30).value();
            const Particles& p = frame->particles;
            std::array<int, 10> parts{}; // of the 0.2 m that it goes in a step
            int all = 0;
            for (std::size_t i = 0; i < p.capacity; ++i) {
                const float steps = p.x[i] / 0.2F;
                if (p.birthStep[i] != Particles::kUnborn && steps > 2.0F && steps < 28.0F) {
                    ++parts[static_cast<std::size_t>((steps - std::floor(steps)) * 9.999F)];
                    ++all;
                }
            }
            QVERIFY(all > 2000);
            for (const int part : parts) {
                QVERIFY(near(10.0 * part, all, 0.3 * all)); // it was from nearly none to two and a half times as many
            }
        }
    }

    void airWhoseRatesRepeatIsAnotherInALongerTimeline()
    {
        Effect effect = hanging(Coupling::Carried);
        effect.timeline.loop = false;
        effect.wind.gust = 0.5F;
        Track rate{&knownParameter("wind.gust_rate"), {{0.0, 0.5F, Ease::Linear}, {1.0, 3.0F}}};
        AirCache shelf(4);
        const auto airOf = [&](int length) {
            effect.timeline.length = length;
            Tracks tracks;
            tracks.set(rate);
            return shelf.airOf(sampled(effect, tracks));
        };
        QVERIFY(airOf(30) == airOf(300)); // it goes on as it is at the last key
        rate.after = Extrapolation::Loop;
        QVERIFY(airOf(30) != airOf(300));
    }

    void aPlayedFrameIsTheOneAlone()
    {
        Effect effect = hanging(Coupling::Carried);
        effect.air.obstacle = Obstacle::Sphere;
        const SampledEffect whole = sampled(effect, comingAt(2.5F));
        Simulator played(whole);
        for (int frame = 0; frame < 18; ++frame) {
            (void)played.frame(frame).value();
        }
        Simulator alone(whole);
        QVERIFY(sameBits(played.frame(18).value()->particles, alone.frame(18).value()->particles));
    }

    void anObstacleOfAGameMoves()
    {
        Effect effect = hanging(Coupling::Free);
        effect.air.obstacle = Obstacle::Box;
        effect.air.obstaclePosition = {-2.0F, 2.0F, 0.0F};
        Result<LiveScene> live = LiveScene::start(Scene(effect));
        QVERIFY2(live.ok(), live ? "" : live.error().text().c_str());
        constexpr float kSpeed = 3.0F;
        for (int step = 0; step < 20; ++step) {
            effect.air.obstaclePosition.x = -2.0F + kSpeed * static_cast<float>(step) / 30.0F;
            QVERIFY(live.value().setEffect(0, effect).ok());
            QVERIFY(live.value().step(1.0 / kFrameRate).ok());
        }
        const Particles& p = live.value().particles(0);
        int touched = 0;
        for (std::size_t i = 0; i < p.capacity; ++i) {
            if (p.birthStep[i] != Particles::kUnborn && p.vx[i] != 0.0F) {
                QVERIFY(near(static_cast<double>(p.vx[i]), 1.5 * static_cast<double>(kSpeed), 1e-2));
                ++touched;
            }
        }
        QVERIFY(touched > 50);
        // In two steps of a call it goes half the way each.
        effect.air.obstaclePosition.x += 0.2F;
        QVERIFY(live.value().setEffect(0, effect).ok());
        QCOMPARE(live.value().step(2.0 / kFrameRate).value(), 2);
        QVERIFY(std::none_of(p.vx.begin(), p.vx.end(), [](float v) { return v > 1.6F * kSpeed; }));
        // One that is set far away is there at once, and pushes nothing.
        effect.air.obstaclePosition.x = 4.0F;
        QVERIFY(live.value().setEffect(0, effect).ok());
        QVERIFY(live.value().step(1.0 / kFrameRate).ok());
        QVERIFY(std::none_of(p.vx.begin(), p.vx.end(), [](float v) { return v > 10.0F; }));
    }
};

QTEST_GUILESS_MAIN(KeyedMotionTest)
#include "keyed_motion_test.moc"
