// The laws of motion beyond the 2012 model, held against closed forms and exact distributions.

#include "tests/helpers.h"

#include "core/base/hash.h"
#include "core/simulation/step.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// Particles that are all born at once, between no steps.
Effect burstOf(int count)
{
    Effect effect = thesisEffect(count);
    effect.emitter.mode = EmissionMode::Burst;
    effect.emitter.burstDuration = 0.0F;
    return effect;
}

/// The largest distance between the distribution of a sample and the uniform one on [low, high] (Kolmogorov and
/// Smirnov).
double distanceFromUniform(std::vector<double> sample, double low, double high)
{
    std::sort(sample.begin(), sample.end());
    const auto n = static_cast<double>(sample.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < sample.size(); ++i) {
        const double expected = (sample[i] - low) / (high - low);
        largest = std::max({largest, std::abs(static_cast<double>(i + 1) / n - expected),
            std::abs(static_cast<double>(i) / n - expected)});
    }
    return largest;
}

/// Critical value of that distance at this level, times the square root of the sample's size.
constexpr double kOneInTenThousand = 2.23;

glm::dvec3 velocityOf(const Frame& frame, std::size_t i)
{
    return {frame.particles.vx[i], frame.particles.vy[i], frame.particles.vz[i]};
}

glm::dvec3 positionOf(const Frame& frame, std::size_t i)
{
    return {frame.particles.x[i], frame.particles.y[i], frame.particles.z[i]};
}

/// The divergence of the air that carries particles, as a share of its gradient: both root mean square in a box above
/// the emitter, by central differences between particles that take one step. One place in thirty is left out, with the
/// most: half-way between two rings, where the flow is smooth but its slope is not, differences from one ring to the
/// other say nothing.
double divergenceOfAir(const Effect& effect)
{
    constexpr std::size_t kPlaces = 3000;
    constexpr float kHalf = 0.004F;
    const SimulationModel model(sampled(effect));
    Particles before;
    before.reset(6 * kPlaces);
    for (std::uint32_t i = 0; i < kPlaces; ++i) {
        const glm::vec3 place(signedFloat(mixBits(3 * i)), 1.6F + 1.4F * signedFloat(mixBits(3 * i + 1)),
            signedFloat(mixBits(3 * i + 2)));
        for (int side = 0; side < 6; ++side) {
            glm::vec3 at = place;
            at[side / 2] += side % 2 == 0 ? kHalf : -kHalf;
            const std::size_t slot = 6 * std::size_t(i) + static_cast<std::size_t>(side);
            before.x[slot] = at.x;
            before.y[slot] = at.y;
            before.z[slot] = at.z;
            before.birthStep[slot] = 0;
        }
    }
    Particles after = before;
    for (std::size_t chunk = 0; chunk < after.chunks(); ++chunk) {
        stepChunk(model.constants(model.schedule().firstStep + 3), after, chunk);
    }
    const auto moved = [&](std::size_t i) {
        return glm::dvec3(after.x[i], after.y[i], after.z[i]) - glm::dvec3(before.x[i], before.y[i], before.z[i]);
    };
    std::vector<double> squares;
    double gradient = 0.0;
    for (std::size_t i = 0; i < kPlaces; ++i) {
        double trace = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t slot = 6 * i + 2 * static_cast<std::size_t>(axis);
            const glm::dvec3 slope = moved(slot) - moved(slot + 1);
            trace += slope[axis];
            gradient += glm::dot(slope, slope);
        }
        squares.push_back(trace * trace);
    }
    std::sort(squares.begin(), squares.end());
    const double divergence = std::accumulate(squares.begin(), squares.end() - kPlaces / 30, 0.0);
    return std::sqrt(divergence / gradient);
}

} // namespace

class MotionTest : public QObject {
    Q_OBJECT

private slots:
    void directionsAreSpreadEvenlyOverTheCone_data()
    {
        QTest::addColumn<float>("spread");
        for (const float spread : {1.0F, 30.0F, 90.0F, 180.0F}) {
            QTest::addRow("%g", static_cast<double>(spread)) << spread;
        }
    }
    void directionsAreSpreadEvenlyOverTheCone()
    {
        QFETCH(float, spread);
        constexpr int kMany = 40000;
        Effect effect = burstOf(kMany);
        effect.emitter.normal = glm::normalize(glm::vec3(0.3F, -0.8F, 0.5F));
        effect.emitter.spread = spread;
        const auto frame = frameOf(effect, 0);
        std::vector<double> heights; // 1 - cos(angle), from the chord so that small angles keep their digits
        for (std::size_t i = 0; i < kMany; ++i) {
            const double chord = glm::length(velocityOf(*frame, i) - glm::dvec3(effect.emitter.normal));
            heights.push_back(0.5 * chord * chord);
        }
        const double distance =
            distanceFromUniform(heights, 0.0, 1.0 - std::cos(static_cast<double>(spread) * M_PI / 180.0));
        QVERIFY2(distance < kOneInTenThousand / std::sqrt(kMany), qPrintable(QString::number(distance)));
    }

    void aVortexAloneTurnsEveryParticleOnItsCircle_data()
    {
        QTest::addColumn<glm::vec3>("axis");
        QTest::addColumn<int>("stepsPerFrame");
        QTest::newRow("upright") << glm::vec3(0.0F, 1.0F, 0.0F) << 1;
        QTest::newRow("upright, in small steps") << glm::vec3(0.0F, 1.0F, 0.0F) << 4;
        QTest::newRow("leaning") << glm::vec3(0.6F, 0.64F, 0.48F) << 1;
    }
    void aVortexAloneTurnsEveryParticleOnItsCircle()
    {
        QFETCH(glm::vec3, axis);
        QFETCH(int, stepsPerFrame);
        Effect effect = burstOf(500);
        effect.emitter.speed = 0.0F;
        effect.emitter.position = {0.3F, -0.2F, 0.7F};
        effect.life.fadeRate = 0.005F; // 20 s
        effect.vortex.strength = 1.0F;
        effect.vortex.radius = 0.5F;
        effect.vortex.axis = axis;
        effect.timeline.stepsPerFrame = stepsPerFrame;
        constexpr double kSeconds = 10.0;
        const auto before = frameOf(effect, 0);
        const auto after = frameOf(effect, static_cast<int>(kSeconds) * effect.timeline.frameRate);
        const glm::dvec3 pivot(effect.emitter.position);
        const glm::dvec3 n = glm::normalize(glm::dvec3(axis));
        for (std::size_t i = 0; i < 500; ++i) {
            const glm::dvec3 from = positionOf(*before, i) - pivot;
            const glm::dvec3 along = n * glm::dot(n, from);
            const double radius = glm::length(from - along);
            const double angle = 2.0 * 1.0 * 0.5 / (0.25 + radius * radius) * kSeconds; // up to 40 radians
            const glm::dvec3 expected =
                along + (from - along) * std::cos(angle) + glm::cross(n, from) * std::sin(angle);
            QVERIFY(near(glm::distance(positionOf(*after, i) - pivot, expected), 0.0, 2e-3 * radius));
        }
    }

    void dragIsExactWhateverTheStep_data()
    {
        QTest::addColumn<float>("drag");
        QTest::addColumn<int>("frameRate");
        for (const float drag : {1e-4F, 0.05F, 0.8F, 5.0F, 29.0F, 100.0F}) {
            for (const int frameRate : {30, 240}) {
                QTest::addRow("%g at %d", static_cast<double>(drag), frameRate) << drag << frameRate;
            }
        }
    }
    void dragIsExactWhateverTheStep()
    {
        // V' = a - D V: V = a / D + (V0 - a / D) e^(-D t).
        QFETCH(float, drag);
        QFETCH(int, frameRate);
        Effect effect = burstOf(1);
        effect.emitter.normal = {0.0F, 1.0F, 0.0F};
        effect.emitter.speed = 1.0F;
        effect.motion.gravity = 3.0F;
        effect.motion.drag = drag;
        effect.timeline.frameRate = frameRate;
        const auto terminal = -3.0 / static_cast<double>(drag);
        for (const int seconds : {0, 1, 4}) {
            const int frame = seconds == 0 ? 1 : seconds * frameRate;
            const double t = static_cast<double>(frame) / frameRate;
            const double expected = 1.0 + (1.0 - terminal) * std::expm1(-static_cast<double>(drag) * t);
            QVERIFY(near(velocityOf(*frameOf(effect, frame), 0).y, expected,
                1e-5 * (1.0 + std::abs(expected)) * std::sqrt(t * frameRate / 30.0)));
        }
    }

    void stepsOfAFrameDoNotChangeTheRandomWalk()
    {
        // The source's draw a frame: after n frames each component has the variance n (a T)^2 / 3.
        constexpr int kMany = 20000;
        for (const int steps : {1, 2, 8}) {
            Effect effect = burstOf(kMany);
            effect.motion.randomness = 1.0F;
            effect.wind.strength = 3.0F;
            effect.motion.buoyancy = 2.0F;
            effect.motion.cooling = 0.0F;
            effect.timeline.stepsPerFrame = steps;
            const auto frame = frameOf(effect, 10);
            const std::vector<float> vx(frame->particles.vx.begin(), frame->particles.vx.begin() + kMany);
            const std::vector<float> vy(frame->particles.vy.begin(), frame->particles.vy.begin() + kMany);
            const double error = 5.0 * std::sqrt(2.0 / kMany);
            QVERIFY(near(Moments::of(vx).variance / (10.0 * 0.1 * 0.1 / 3.0), 1.0, error));
            QVERIFY(near(Moments::of(vy).variance / (10.0 * std::pow(2.0 / 30.0, 2.0) / 3.0), 1.0, error));
        }
    }

    void stepsOfAFrameDoNotChangeTheRotationJitter()
    {
        for (const int steps : {1, 4}) {
            Effect effect = thesisEffect(1);
            effect.motion.rotationJitter = 90.0F;
            effect.timeline.stepsPerFrame = steps;
            const SimulationModel model(sampled(effect));
            std::vector<double> angles; // of frames, degrees
            for (int frame = 0; frame < 20000; ++frame) {
                double sum = 0.0;
                for (int step = 0; step < steps; ++step) {
                    sum += static_cast<double>(model.rotationAt(static_cast<std::int64_t>(frame) * steps + step))
                        * 180.0 / M_PI;
                }
                angles.push_back(sum);
            }
            QVERIFY(near(Moments::of(angles).variance / (3.0 * 3.0 / 3.0), 1.0, 5.0 * std::sqrt(2.0 / 20000)));
        }
    }

    void heatVariesAroundItsMean()
    {
        constexpr int kMany = 40000;
        Effect effect = burstOf(kMany);
        effect.emitter.speed = 0.0F;
        effect.motion.buoyancy = 3.0F;
        effect.motion.cooling = 0.0F;
        effect.motion.heatVariance = 0.6F;
        const auto frame = frameOf(effect, 1);
        std::vector<double> heats;
        for (std::size_t i = 0; i < kMany; ++i) {
            heats.push_back(velocityOf(*frame, i).y * 30.0 / 3.0);
        }
        const double distance = distanceFromUniform(heats, 0.7, 1.3); // 1 - v/2 to 1 + v/2
        QVERIFY2(distance < kOneInTenThousand / std::sqrt(kMany), qPrintable(QString::number(distance)));
    }

    void forcesThatRunAwayEndInABound()
    {
        Effect effect = thesisEffect(200);
        effect.motion.pull = -100.0F; // e^(10 t) for 10 s
        effect.turbulence.strength = 1.0F;
        effect.rings.strength = 1.0F;
        effect.vortex.strength = 1.0F;
        effect.life.fadeRate = 0.01F;
        const auto frame = frameOf(effect, 299);
        double fastest = 0.0;
        for (std::size_t i = 0; i < 200; ++i) {
            const glm::dvec3 v = velocityOf(*frame, i);
            const glm::dvec3 p = positionOf(*frame, i);
            QVERIFY(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
            QVERIFY(std::abs(v.x) <= 1e6 && std::abs(v.y) <= 1e6 && std::abs(v.z) <= 1e6);
            fastest = std::max(fastest, std::abs(v.x));
        }
        QCOMPARE(fastest, 1e6);
    }

    void withoutDragTheWholeModelHasTheBitsOfThe2012Model()
    {
        Effect effect = thesisEffect(3000);
        effect.emitter.velocityRandomness = 1.0F;
        effect.wind.strength = 0.5F;
        effect.wind.angle = 37.0F;
        effect.motion.gravity = 0.5F;
        effect.motion.randomness = 0.7F;
        const auto start = frameOf(effect, 100);
        StepConstants constants = start->model->constants(101);
        QVERIFY(constants.plain);
        Particles plain = start->particles;
        stepChunk(constants, plain, 1);
        constants.plain = false;
        Particles whole = start->particles;
        stepChunk(constants, whole, 1);
        QVERIFY(sameBits(plain, whole));
    }

    void airHasNoDivergence_data()
    {
        QTest::addColumn<float>("growth");
        QTest::addColumn<float>("rings");
        QTest::addColumn<float>("widening");
        QTest::addColumn<float>("variance");
        QTest::addColumn<double>("most"); // of the gradient, root mean square
        QTest::newRow("turbulence") << 0.0F << 0.0F << 0.0F << 0.0F << 1e-3;
        QTest::newRow("swirls that grow") << 0.5F << 0.0F << 0.0F << 0.0F << 1e-3;
        QTest::newRow("swirls that grow fast") << 2.0F << 0.0F << 0.0F << 0.0F << 1e-3;
        QTest::newRow("rings") << 0.0F << 1.0F << 0.0F << 0.0F << 1e-3;
        QTest::newRow("rings that widen") << 0.0F << 1.0F << 0.3F << 0.0F << 1e-3;
        QTest::newRow("rings that vary") << 0.0F << 1.0F << 0.0F << 0.6F << 1e-3;
        QTest::newRow("rings that vary and widen fast") << 0.0F << 1.0F << 1.0F << 1.0F << 1e-3;
        QTest::newRow("all") << 1.0F << 0.5F << 0.3F << 0.6F << 1e-3;
    }
    void airHasNoDivergence()
    {
        QFETCH(float, growth);
        QFETCH(float, rings);
        QFETCH(float, widening);
        QFETCH(float, variance);
        QFETCH(double, most);
        Effect effect = thesisEffect(1);
        effect.timeline.frameRate = 1;
        effect.timeline.prewarm = true;
        effect.turbulence.strength = 1.0F - rings;
        effect.turbulence.onset = 0.0F;
        effect.turbulence.octaves = 3;
        effect.turbulence.growth = growth;
        effect.rings.strength = rings;
        effect.rings.widening = widening;
        effect.rings.variance = variance;
        const double share = divergenceOfAir(effect);
        QVERIFY2(share < most, qPrintable(QString::number(share)));
    }

    void dragIsExactForWaysAsForVelocities_data()
    {
        QTest::addColumn<float>("drag");
        QTest::addColumn<int>("steps");
        QTest::addColumn<bool>("betweenSteps");
        for (const float drag : {0.001F, 0.5F, 2.0F, 2.9F, 3.1F, 10.0F, 29.0F, 60.0F, 100.0F}) {
            for (const int steps : {1, 3, 8}) {
                for (const bool between : {false, true}) {
                    QTest::addRow("%g/s, %d steps, %s", static_cast<double>(drag), steps,
                        between ? "born between" : "born at steps")
                        << drag << steps << between;
                }
            }
        }
    }
    void dragIsExactForWaysAsForVelocities()
    {
        // x' = v, v' = g - D v: x = v0 tau + g (t - tau) / D with tau = (1 - e^(-D t)) / D.
        QFETCH(float, drag);
        QFETCH(int, steps);
        QFETCH(bool, betweenSteps);
        constexpr double kSpeed = 4.0;
        constexpr double kGravity = 3.0;
        Effect effect = thesisEffect(1500);
        effect.emitter.subframe = betweenSteps;
        effect.emitter.speed = static_cast<float>(kSpeed);
        effect.motion.gravity = static_cast<float>(kGravity);
        effect.motion.drag = drag;
        effect.timeline.stepsPerFrame = steps;
        const auto frame = frameOf(effect, 60);
        const auto rate = static_cast<double>(drag);
        int seen = 0;
        for (std::size_t i = 0; i < frame->particles.capacity; ++i) {
            const Lifecycle cycle = lifecycle(*frame, i);
            if (cycle.alive) {
                ++seen;
                const double t = cycle.age;
                const double tau = -std::expm1(-rate * t) / rate;
                const double way = kSpeed * tau - kGravity * (t - tau) / rate;
                const double speed = kSpeed - (kGravity + rate * kSpeed) * tau;
                QVERIFY(near(positionOf(*frame, i).y, way, 2e-5 + 2e-5 * kSpeed * tau));
                QVERIFY(near(velocityOf(*frame, i).y, speed, 1e-4));
            }
        }
        QVERIFY(seen > 300);
    }

    void particlesAreAsOldAsTheirWayIsLong()
    {
        // Nothing but the velocity of birth: what was born between two steps has lived, faded and moved for the same
        // time.
        Effect effect = thesisEffect(6000);
        effect.emitter.subframe = true;
        effect.emitter.speed = 3.0F;
        effect.life.lifetimeVariance = 0.5F;
        const auto frame = frameOf(effect, 170);
        std::vector<double> partsOfAStep;
        for (std::size_t i = 0; i < frame->particles.capacity; ++i) {
            const Lifecycle cycle = lifecycle(*frame, i);
            if (cycle.alive) {
                const double age = positionOf(*frame, i).y / 3.0;
                QVERIFY(near(cycle.age, age, 1e-5));
                QVERIFY(near(cycle.alpha, 0.1 * (1.0 - static_cast<double>(cycle.life)), 1e-6));
                partsOfAStep.push_back(age * 30.0 - std::floor(age * 30.0));
            }
        }
        const double distance = distanceFromUniform(partsOfAStep, 0.0, 1.0);
        QVERIFY2(distance < kOneInTenThousand / std::sqrt(static_cast<double>(partsOfAStep.size())),
            qPrintable(QString::number(distance)));
    }

    void particlesBornBetweenStepsTurnForAsLongAsTheyHaveLived_data()
    {
        QTest::addColumn<float>("rotation");
        QTest::addColumn<float>("vortex");
        QTest::newRow("rotation of the whole cloud") << 90.0F << 0.0F;
        QTest::newRow("vortex") << 0.0F << 1.0F;
    }
    void particlesBornBetweenStepsTurnForAsLongAsTheyHaveLived()
    {
        QFETCH(float, rotation);
        QFETCH(float, vortex);
        Effect effect = thesisEffect(3000);
        effect.emitter.subframe = true;
        effect.emitter.speed = 0.0F;
        effect.emitter.depth = 0.0F; // born on a line along x
        effect.motion.rotation = rotation;
        effect.vortex.strength = vortex;
        const auto frame = frameOf(effect, 20);
        int seen = 0;
        for (std::size_t i = 0; i < frame->particles.capacity; ++i) {
            const Lifecycle cycle = lifecycle(*frame, i);
            if (cycle.alive) {
                ++seen;
                const glm::dvec3 p = positionOf(*frame, i);
                const double radius = glm::length(p);
                const auto rate = static_cast<double>(rotation) * M_PI / 180.0
                    + static_cast<double>(vortex) / (0.25 + radius * radius);
                const double angle = rate * static_cast<double>(cycle.age);
                QVERIFY(near(p.x * std::sin(angle) + p.z * std::cos(angle), 0.0,
                    1e-5 + 1e-4 * radius)); // turned back onto the line
            }
        }
        QVERIFY(seen > 400);
    }

    void smokeLeavesAsAStreamAndNotInPlates()
    {
        // A point from which the flow of rings alone carries the smoke, 0.1 m and 600 particles a step.
        Effect effect = thesisEffect(90000);
        effect.emitter.subframe = true;
        effect.emitter.speed = 0.0F;
        effect.emitter.width = 0.0F;
        effect.emitter.depth = 0.0F;
        effect.rings.strength = 3.0F;
        effect.rings.spacing = 5.0F;
        effect.rings.radius = 0.9F;
        effect.rings.variance = 0.0F;
        effect.rings.speed = 0.8F;
        const auto frame = frameOf(effect, 30);
        std::vector<double> heights;
        for (std::size_t i = 0; i < frame->particles.capacity; ++i) {
            if (lifecycle(*frame, i).alive) {
                heights.push_back(positionOf(*frame, i).y);
            }
        }
        std::sort(heights.begin(), heights.end());
        QVERIFY(heights.back() > 0.5);
        double gap = 0.0;
        for (std::size_t i = 1; i < heights.size(); ++i) {
            gap = std::max(gap, heights[i] - heights[i - 1]);
        }
        QVERIFY2(gap < 0.005, qPrintable(QString::number(gap)));
    }
};

QTEST_GUILESS_MAIN(MotionTest)
#include "motion_test.moc"
