#include "tests/helpers.h"

#include "core/base/hash.h"
#include "core/effect/known_parameter.h"
#include "core/simulation/step.h"

#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

using namespace fumage;
using namespace fumage::tests;

namespace {

Effect turbulent()
{
    Effect effect = thesisEffect(1);
    effect.turbulence.strength = 1.0F;
    effect.turbulence.scale = 1.0F;
    effect.turbulence.octaves = 1;
    effect.turbulence.growth = 0.0F;
    effect.turbulence.onset = 0.0F;
    effect.turbulence.drift = 0.0F;
    effect.turbulence.evolution = 0.5F;
    return effect;
}

struct Velocities {
    std::vector<float> x, y, z;
};

Velocities turbulenceOf(const StepConstants& constants, const std::vector<float>& x, const std::vector<float>& y,
    const std::vector<float>& z)
{
    Velocities v{x, y, z};
    turbulenceAt(constants, x, y, z, v.x, v.y, v.z);
    return v;
}

/// Living particles by (random bits, age): where they are, whatever slot they lie in.
std::map<std::pair<std::uint32_t, std::int64_t>, std::array<float, 6>> byIdentity(const Particles& p, std::int64_t step)
{
    std::map<std::pair<std::uint32_t, std::int64_t>, std::array<float, 6>> out;
    for (std::size_t i = 0; i < p.capacity; ++i) {
        if (p.birthStep[i] != Particles::kUnborn) {
            out[{p.key[i], step - p.birthStep[i]}] = {p.x[i], p.y[i], p.z[i], p.vx[i], p.vy[i], p.vz[i]};
        }
    }
    return out;
}

} // namespace

class SimulationTest : public QObject {
    Q_OBJECT

private slots:
    void scheduleCountsEveryBirthOnce()
    {
        for (const bool loop : {false, true}) {
            for (const EmissionMode mode : {EmissionMode::Continuous, EmissionMode::Burst}) {
                for (const int count : {1, 13, 997}) {
                    Effect effect = thesisEffect(count);
                    effect.timeline.loop = loop;
                    effect.timeline.length = 40;
                    effect.emitter.mode = mode;
                    effect.emitter.burstDuration = 0.33F;
                    const Schedule s = makeSchedule(sampled(effect));
                    std::int64_t most = 0;
                    for (std::int64_t step = 0; step < 700; ++step) {
                        const std::int64_t births = s.birthsBefore(step + 1) - s.birthsBefore(step);
                        QVERIFY(births >= 0);
                        most = std::max(most, s.birthsBefore(step + 1) - s.birthsBefore(step - s.lifetimeSteps + 1));
                    }
                    QVERIFY(most <= s.capacity());
                    QVERIFY(s.capacity() <= kMaxParticles);
                    if (!loop && mode == EmissionMode::Continuous) {
                        QCOMPARE(most, static_cast<std::int64_t>(count));
                        QCOMPARE(s.capacity(), static_cast<std::int64_t>(count));
                    }
                }
            }
        }
    }

    void birthsAreCountedAtTheEndsOfTheRanges()
    {
        Effect effect = thesisEffect(kMaxParticles);
        effect.timeline.loop = true;
        effect.timeline.length = 100'000;
        effect.timeline.stepsPerFrame = 32;
        effect.life.initialAlpha = 0.001F;
        effect.life.fadeRate = 100.0F; // a step
        constexpr std::int64_t kEach = kMaxParticles;
        const Schedule s = makeSchedule(sampled(effect));
        QCOMPARE(s.lifetimeSteps, std::int64_t{1});
        for (const std::int64_t step : {s.loopSteps / 4, s.loopSteps / 2, s.loopSteps - 1, s.loopSteps}) {
            QCOMPARE(s.birthsBefore(step), kEach * step);
        }
        Tracks halved;
        const double middle = 0.5 * lengthInSeconds(effect.timeline);
        halved.set({&knownParameter("emitter.rate"), {{0.0, 1.0F, Ease::Hold}, {middle, 0.5F}}});
        const Schedule keyed = makeSchedule(sampled(effect, halved));
        const std::int64_t quarter = keyed.loopSteps / 4;
        QVERIFY(std::abs(keyed.birthsBefore(quarter) - kEach * quarter) <= kEach);
        QVERIFY(std::abs(keyed.birthsBefore(keyed.loopSteps) - kEach * quarter * 3) <= kEach);
    }

    void aBurstIsBornWithinItsDuration()
    {
        Effect effect = thesisEffect(600);
        effect.emitter.mode = EmissionMode::Burst;
        effect.emitter.burstDuration = 0.2F; // 6 steps
        const Schedule s = makeSchedule(sampled(effect));
        QCOMPARE(s.birthsBefore(3), std::int64_t(300));
        QCOMPARE(s.birthsBefore(6), std::int64_t(600));
        QCOMPARE(s.birthsBefore(1000), std::int64_t(600));
    }

    void anyFrameFromNothingEqualsPlayingToIt()
    {
        const Effect effect = everythingOn();
        const SimulationModel model(sampled(effect));
        const std::int64_t start = model.schedule().firstStep;
        Particles played;
        QVERIFY(advanceFromNothing(model, played, start).ok());
        for (const std::int64_t step : {1, 2, 17, 150, 400}) {
            Particles next = played;
            QVERIFY(advance(model, next, start, start + step).ok());
            Particles direct;
            QVERIFY(advanceFromNothing(model, direct, start + step).ok());
            QVERIFY(sameBits(next, direct));
        }
    }

    void stepsMayBeTakenInAnyPortions()
    {
        const SimulationModel model(sampled(everythingOn()));
        Particles a;
        QVERIFY(advanceFromNothing(model, a, 200).ok());
        Particles b = a;
        QVERIFY(advance(model, a, 200, 331).ok());
        for (std::int64_t step = 200; step < 331; ++step) {
            QVERIFY(advance(model, b, step, step + 1).ok());
        }
        QVERIFY(sameBits(a, b));
    }

    void framesDoNotDependOnTheirOrder()
    {
        const Effect effect = everythingOn();
        Simulator forwards(sampled(effect));
        std::map<int, std::shared_ptr<const Frame>> frames;
        for (int n = 0; n <= 60; ++n) {
            frames[n] = forwards.frame(n).value();
        }
        Simulator jumping(sampled(effect), 1000000);
        for (const int n : {60, 3, 41, 40, 59, 0, 12, 60, 11}) {
            QVERIFY(sameBits(jumping.frame(n).value()->particles, frames[n]->particles));
        }
    }

    void aLoopClosesByItself()
    {
        // Not through the modulo of Simulator::frame(): the steps themselves come back to where they were.
        for (const float fade : {0.02F, 0.2F}) { // lives longer and shorter than the loop
            Effect effect = everythingOn();
            effect.life.fadeRate = fade;
            effect.timeline.loop = true;
            effect.timeline.length = 48;
            effect.turbulence.drift = 0.7F;
            const SimulationModel model(sampled(effect));
            const std::int64_t step = model.schedule().firstStep + 20;
            Particles here;
            QVERIFY(advanceFromNothing(model, here, step).ok());
            Particles later = here;
            QVERIFY(advance(model, later, step, step + model.schedule().loopSteps).ok());
            const auto a = byIdentity(here, step);
            const auto b = byIdentity(later, step + model.schedule().loopSteps);
            QVERIFY(!a.empty());
            QVERIFY(a == b);
        }
    }

    void loopingFramesAWholeLoopApartAreOne()
    {
        Effect effect = everythingOn();
        effect.timeline.loop = true;
        effect.timeline.length = 30;
        Simulator simulator(sampled(effect));
        const auto first = simulator.frame(7).value();
        const auto again = simulator.frame(37).value();
        QVERIFY(sameBits(first->particles, again->particles));
    }

    void curlNoiseHasNoDivergence()
    {
        const StepConstants constants = SimulationModel(sampled(turbulent())).constants(7);
        constexpr float h = 1e-2F;
        double divergence = 0.0;
        double gradient = 0.0;
        for (std::uint32_t i = 0; i < 2000; ++i) {
            const float cx = 10.0F * signedFloat(mixBits(3 * i));
            const float cy = 10.0F * signedFloat(mixBits(3 * i + 1));
            const float cz = 10.0F * signedFloat(mixBits(3 * i + 2));
            const Velocities v = turbulenceOf(constants, {cx + h, cx - h, cx, cx, cx, cx},
                {cy, cy, cy + h, cy - h, cy, cy}, {cz, cz, cz, cz, cz + h, cz - h});
            const double dx = static_cast<double>(v.x[0] - v.x[1]) / (2.0 * static_cast<double>(h));
            const double dy = static_cast<double>(v.y[2] - v.y[3]) / (2.0 * static_cast<double>(h));
            const double dz = static_cast<double>(v.z[4] - v.z[5]) / (2.0 * static_cast<double>(h));
            divergence += (dx + dy + dz) * (dx + dy + dz);
            gradient += dx * dx + dy * dy + dz * dz;
        }
        QVERIFY(gradient > 100.0);
        // What is left is the error of the central difference, of order h^2.
        QVERIFY2(
            std::sqrt(divergence / gradient) < 0.01, qPrintable(QString::number(std::sqrt(divergence / gradient))));
    }

    void airAroundTheEmitterShearsLikeAirElsewhere()
    {
        Effect effect = turbulent();
        effect.turbulence.octaves = 4;
        effect.turbulence.evolution = 0.0F;
        constexpr float h = 1e-2F;
        double here = 0.0;
        double elsewhere = 0.0;
        for (std::uint32_t seed = 1; seed <= 400; ++seed) {
            effect.emitter.seed = seed;
            const float far = 3.0F + signedFloat(mixBits(seed));
            const Velocities v = turbulenceOf(SimulationModel(sampled(effect)).constants(7), {h, -h, far + h, far - h},
                {0.0F, 0.0F, far, far}, {0.0F, 0.0F, -far, -far});
            here += std::pow(static_cast<double>(v.y[0] - v.y[1]), 2.0);
            elsewhere += std::pow(static_cast<double>(v.y[2] - v.y[3]), 2.0);
        }
        QVERIFY2(std::abs(std::log(here / elsewhere)) < 0.3, qPrintable(QString::number(here / elsewhere)));
    }

    void turbulenceHasTheSpeedThatIsAskedWhateverItsOctaves_data()
    {
        QTest::addColumn<int>("octaves");
        QTest::addColumn<float>("roughness");
        QTest::newRow("one") << 1 << 0.7F;
        QTest::newRow("smooth") << 5 << 0.0F;
        QTest::newRow("usual") << 4 << 0.72F;
        QTest::newRow("all alike") << 8 << 1.0F;
    }
    void turbulenceHasTheSpeedThatIsAskedWhateverItsOctaves()
    {
        QFETCH(int, octaves);
        QFETCH(float, roughness);
        Effect effect = turbulent();
        effect.turbulence.strength = 2.5F;
        effect.turbulence.octaves = octaves;
        effect.turbulence.roughness = roughness;
        const StepConstants constants = SimulationModel(sampled(effect)).constants(11);
        std::vector<float> x(60000);
        std::vector<float> y(x.size());
        std::vector<float> z(x.size());
        for (std::uint32_t i = 0; i < x.size(); ++i) {
            x[i] = 200.0F * signedFloat(mixBits(3 * i));
            y[i] = 200.0F * signedFloat(mixBits(3 * i + 1));
            z[i] = 200.0F * signedFloat(mixBits(3 * i + 2));
        }
        const Velocities v = turbulenceOf(constants, x, y, z);
        double square = 0.0;
        const std::vector<float>* components[] = {&v.x, &v.y, &v.z};
        for (const std::vector<float>* component : components) {
            const Moments m = Moments::of(*component);
            QVERIFY2(std::abs(m.mean) < 0.03 * 2.5, qPrintable(QString::number(m.mean)));
            square += m.variance;
        }
        QVERIFY2(std::abs(std::sqrt(square) / 2.5 - 1.0) < 0.02, qPrintable(QString::number(std::sqrt(square))));
        QVERIFY(std::abs(correlation(v.x, v.y)) < 0.03);
    }

    void curlNoiseEvolvesSmoothly()
    {
        // Through slices of time, through whole units of drift, and through the end of a loop.
        for (const bool loop : {false, true}) {
            Effect effect = turbulent();
            effect.turbulence.strength = 2.0F;
            effect.turbulence.octaves = 2;
            effect.turbulence.drift = 0.5F;
            effect.timeline.loop = loop;
            effect.timeline.length = 110;
            const SimulationModel model(sampled(effect));
            const std::vector<float> x{0.3F, 1.7F, -2.2F};
            // A jump shows in the change of the change from step to step.
            double largest = 0.0;
            double moves = 0.0;
            std::array<Velocities, 3> v{
                turbulenceOf(model.constants(0), x, x, x), turbulenceOf(model.constants(1), x, x, x), {}};
            for (int step = 2; step < 300; ++step) {
                v[2] = turbulenceOf(model.constants(step), x, x, x);
                for (std::size_t i = 0; i < x.size(); ++i) {
                    largest =
                        std::max(largest, std::abs(static_cast<double>(v[2].x[i] - 2.0F * v[1].x[i] + v[0].x[i])));
                    moves = std::max(moves, std::abs(static_cast<double>(v[2].x[i] - v[1].x[i])));
                }
                std::rotate(v.begin(), v.begin() + 1, v.end());
            }
            QVERIFY2(moves > 0.3, qPrintable(QString::number(moves)));
            QVERIFY2(largest < 0.2, qPrintable(QString::number(largest)));
        }
    }

    void curlNoiseDriftsUpwards()
    {
        // Every octave and both slices move by drift times time: who moves along sees the swirls turn over slowly, who
        // stands sees others pass.
        Effect effect = turbulent();
        effect.turbulence.octaves = 3;
        effect.turbulence.scale = 0.3F;
        effect.turbulence.drift = 2.3F;
        effect.turbulence.evolution = 0.05F;
        const SimulationModel model(sampled(effect));
        std::vector<float> x(4000);
        std::vector<float> y(x.size());
        std::vector<float> moved(x.size());
        std::vector<float> z(x.size());
        constexpr int kFrom = 59; // the first octave changes its slices after 600 steps, the third after 238
        constexpr int kSteps = 6;
        for (std::uint32_t i = 0; i < x.size(); ++i) {
            x[i] = 9.0F * signedFloat(mixBits(3 * i));
            y[i] = 9.0F * signedFloat(mixBits(3 * i + 1));
            z[i] = 9.0F * signedFloat(mixBits(3 * i + 2));
            moved[i] = y[i] + effect.turbulence.drift * model.schedule().dt * kSteps;
        }
        const Velocities before = turbulenceOf(model.constants(kFrom), x, y, z);
        const Velocities along = turbulenceOf(model.constants(kFrom + kSteps), x, moved, z);
        const Velocities standing = turbulenceOf(model.constants(kFrom + kSteps), x, y, z);
        QVERIFY2(correlation(before.y, along.y) > 0.98, qPrintable(QString::number(correlation(before.y, along.y))));
        QVERIFY2(
            correlation(before.y, standing.y) < 0.3, qPrintable(QString::number(correlation(before.y, standing.y))));
    }

    void swirlsGrowWithHeight()
    {
        Effect effect = turbulent();
        effect.turbulence.growth = 1.0F;
        const StepConstants constants = SimulationModel(sampled(effect)).constants(3);
        const auto roughness = [&](float height) {
            double sum = 0.0;
            for (std::uint32_t i = 0; i < 3000; ++i) {
                const float x = 20.0F * signedFloat(mixBits(i));
                const Velocities v = turbulenceOf(constants, {x, x + 0.1F}, {height, height}, {0.0F, 0.0F});
                sum += std::pow(static_cast<double>(v.y[1] - v.y[0]), 2.0);
            }
            return std::sqrt(sum);
        };
        QVERIFY(roughness(0.1F) > 2.0 * roughness(4.0F));
    }

    void spreadIsACone()
    {
        Effect effect = thesisEffect(20000);
        effect.emitter.spread = 30.0F;
        effect.emitter.mode = EmissionMode::Burst;
        effect.emitter.burstDuration = 0.0F;
        const auto frame = frameOf(effect, 0);
        float widest = 0.0F;
        for (std::size_t i = 0; i < frame->particles.capacity; ++i) {
            const float cosine = frame->particles.vy[i]
                / std::sqrt(frame->particles.vx[i] * frame->particles.vx[i]
                    + frame->particles.vy[i] * frame->particles.vy[i]
                    + frame->particles.vz[i] * frame->particles.vz[i]);
            widest = std::max(widest, std::acos(std::min(1.0F, cosine)) * 57.29578F);
        }
        QVERIFY(widest <= 30.1F && widest > 29.0F);
    }

    void discAndSphereAreFilledEvenly()
    {
        for (const EmitterShape shape : {EmitterShape::Disc, EmitterShape::Sphere}) {
            Effect effect = thesisEffect(40000);
            effect.emitter.shape = shape;
            effect.emitter.radius = 2.0F;
            effect.emitter.mode = EmissionMode::Burst;
            effect.emitter.burstDuration = 0.0F;
            const auto frame = frameOf(effect, 0);
            int inner = 0;
            for (std::size_t i = 0; i < frame->particles.capacity; ++i) {
                const float r2 = frame->particles.x[i] * frame->particles.x[i]
                    + frame->particles.y[i] * frame->particles.y[i] + frame->particles.z[i] * frame->particles.z[i];
                QVERIFY(r2 <= 4.0001F);
                inner += r2 < 1.0F ? 1 : 0;
            }
            const double share = shape == EmitterShape::Disc ? 0.25 : 0.125;
            QVERIFY(std::abs(inner / 40000.0 - share) < 5.0 * std::sqrt(share * (1.0 - share) / 40000.0));
        }
    }

    void lifetimesVaryDownwards()
    {
        Effect effect = thesisEffect(5000);
        effect.emitter.mode = EmissionMode::Burst;
        effect.emitter.burstDuration = 0.0F;
        effect.life.lifetimeVariance = 0.5F;
        const auto aliveAt = [&](int number) {
            const auto frame = frameOf(effect, number);
            const int alive = livingCount(*frame);
            return alive;
        };
        QCOMPARE(aliveAt(74), 5000);
        QVERIFY(std::abs(aliveAt(112) - 2500) < 250);
        QVERIFY(aliveAt(149) < 100);
    }

    void cancellingStops()
    {
        std::stop_source stop;
        stop.request_stop();
        Simulator simulator(sampled(everythingOn()));
        QCOMPARE(simulator.frame(3, stop.get_token()).error().code, ErrorCode::Cancelled);
        QVERIFY(simulator.frame(3).ok());
    }

    void aLongWayToAFrameTellsHowFarItIs()
    {
        Effect effect;
        effect.emitter.count = 10;
        effect.timeline.stepsPerFrame = 32;
        Simulator simulator(sampled(effect));
        int told = 0;
        int all = 0;
        const Task task([&](ProgressPhase work, int done, int total) {
            QCOMPARE(work, ProgressPhase::PreRoll);
            QVERIFY(done > told && done <= total);
            told = done;
            all = total;
        });
        QVERIFY(simulator.frame(60, task).ok());
        QVERIFY(told > 128);
        QCOMPARE(told, all);
        told = 0;
        QVERIFY(simulator.frame(61, task).ok());
        QCOMPARE(told, 0);
    }
};

QTEST_GUILESS_MAIN(SimulationTest)
#include "simulation_test.moc"
