// The equations of the 2012 model, each with a test of its name. Where a draw is random, its exact moments are held
// against the sample within five standard errors; where nothing is, the closed form.

#include "tests/helpers.h"

#include "core/simulation/step.h"

#include <cmath>

#include <glm/geometric.hpp>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kMany = 40000;
constexpr double kErrors = 5.0;

/// Particles that were born at the given frame's step, in a population of which many are born at once.
struct Newborns {
    std::vector<float> x, y, z, vx, vy, vz;

    explicit Newborns(Effect effect)
    {
        effect.emitter.mode = EmissionMode::Burst;
        effect.emitter.burstDuration = 0.0F; // all in one step
        const std::shared_ptr<const Frame> frame = frameOf(effect, 0);
        const Particles& p = frame->particles;
        for (std::size_t i = 0; i < p.capacity; ++i) {
            if (p.birthStep[i] == 0) {
                x.push_back(p.x[i]);
                y.push_back(p.y[i]);
                z.push_back(p.z[i]);
                vx.push_back(p.vx[i]);
                vy.push_back(p.vy[i]);
                vz.push_back(p.vz[i]);
            }
        }
    }
};

/// What one step of an effect does to particles that stand still at some places.
std::vector<glm::dvec3> carriedBy(const Effect& effect, std::int64_t step, const std::vector<glm::vec3>& places)
{
    const SimulationModel model(sampled(effect));
    Particles p;
    p.reset(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        p.x[i] = places[i].x;
        p.y[i] = places[i].y;
        p.z[i] = places[i].z;
        p.birthStep[i] = 0;
    }
    stepChunk(model.constants(step), p, 0);
    std::vector<glm::dvec3> velocities;
    for (std::size_t i = 0; i < places.size(); ++i) {
        velocities.push_back(glm::dvec3(p.x[i] - places[i].x, p.y[i] - places[i].y, p.z[i] - places[i].z)
            / static_cast<double>(model.schedule().dt));
    }
    return velocities;
}

/// Rings alone, all alike and on the axis.
Effect evenRings()
{
    Effect effect = thesisEffect(1);
    effect.rings.strength = 2.0F;
    effect.rings.speed = 1.5F;
    effect.rings.radius = 0.4F;
    effect.rings.widening = 0.0F;
    effect.rings.spacing = 1.0F;
    effect.rings.followers = 0.5F;
    effect.rings.variance = 0.0F;
    return effect;
}

/// Uniform on [low, high]: mean, variance (high - low)^2 / 12 and range.
bool isUniform(const std::vector<float>& values, double low, double high)
{
    const Moments m = Moments::of(values);
    const double n = static_cast<double>(values.size());
    const double width = high - low;
    const double variance = width * width / 12.0;
    // Standard error of the variance of a uniform distribution: its kurtosis is 9/5.
    return near(m.mean, 0.5 * (low + high), kErrors * std::sqrt(variance / n))
        && near(m.variance, variance, kErrors * variance * std::sqrt((9.0 / 5.0 - 1.0) / n)) && m.low >= low - 1e-6
        && m.high <= high + 1e-6 && m.low < low + 0.01 * width && m.high > high - 0.01 * width;
}

bool isIndependent(const std::vector<float>& a, const std::vector<float>& b)
{
    return near(correlation(a, b), 0.0, kErrors / std::sqrt(static_cast<double>(a.size())));
}

/// One particle of a burst at a frame.
struct Trail {
    Effect effect;
    glm::dvec3 position(int frame) const
    {
        const auto f = frameOf(effect, frame);
        return {f->particles.x[0], f->particles.y[0], f->particles.z[0]};
    }
    glm::dvec3 velocity(int frame) const
    {
        const auto f = frameOf(effect, frame);
        return {f->particles.vx[0], f->particles.vy[0], f->particles.vz[0]};
    }
};

Effect oneParticle()
{
    Effect effect = thesisEffect(1);
    effect.emitter.mode = EmissionMode::Burst;
    effect.emitter.burstDuration = 0.0F;
    effect.emitter.width = 0.0F;
    effect.emitter.depth = 0.0F;
    effect.life.fadeRate = 0.001F;
    return effect;
}

/// Changes of velocity of many particles in one step, for each component.
struct Kicks {
    std::vector<float> x, y, z;

    Kicks(const Effect& effect, int frame)
    {
        const auto before = frameOf(effect, frame);
        const auto after = frameOf(effect, frame + 1);
        for (std::size_t i = 0; i < before->particles.capacity; ++i) {
            x.push_back(after->particles.vx[i] - before->particles.vx[i]);
            y.push_back(after->particles.vy[i] - before->particles.vy[i]);
            z.push_back(after->particles.vz[i] - before->particles.vz[i]);
        }
    }
};

Effect randomForces()
{
    Effect effect = thesisEffect(kMany);
    effect.emitter.mode = EmissionMode::Burst;
    effect.emitter.burstDuration = 0.0F;
    effect.motion.randomness = 1.0F;
    effect.wind.strength = 3.0F;
    effect.wind.angle = 30.0F;
    effect.motion.gravity = 2.0F;
    return effect;
}

} // namespace

class ModelTest : public QObject {
    Q_OBJECT

private slots:
    void equationI_birthIsUniformOnTheRectangle()
    {
        Effect effect = thesisEffect(kMany);
        effect.emitter.width = 2.0F;
        effect.emitter.depth = 0.5F;
        effect.emitter.position = {3.0F, 1.0F, -2.0F};
        const Newborns born(effect);
        QCOMPARE(born.x.size(), std::size_t(kMany));
        QVERIFY(isUniform(born.x, 2.0, 4.0));
        QVERIFY(isUniform(born.z, -2.25, -1.75));
        QVERIFY(isIndependent(born.x, born.z));
        for (const float y : born.y) {
            QCOMPARE(y, 1.0F);
        }
    }

    void equationI_planeIsPerpendicularToTheNormal()
    {
        Effect effect = thesisEffect(2000);
        const glm::vec3 n = glm::normalize(glm::vec3(0.3F, -0.8F, 0.5F));
        effect.emitter.normal = n;
        const Newborns born(effect);
        for (std::size_t i = 0; i < born.x.size(); ++i) {
            QVERIFY(std::abs(glm::dot(n, glm::vec3(born.x[i], born.y[i], born.z[i]))) < 1e-6F);
        }
    }

    void equationII_eachComponentHasItsOwnDraw()
    {
        Effect effect = thesisEffect(kMany);
        effect.emitter.velocityRandomness = 1.0F;
        effect.emitter.speed = 2.0F;
        const glm::vec3 n = glm::normalize(glm::vec3(1.0F, 2.0F, -2.0F)); // (1, 2, -2) / 3
        effect.emitter.normal = n;
        const Newborns born(effect);
        QVERIFY(isUniform(born.vx, -2.0 / 3.0, 2.0 / 3.0));
        QVERIFY(isUniform(born.vy, 0.0, 4.0 / 3.0));
        QVERIFY(isUniform(born.vz, -4.0 / 3.0, 4.0 / 3.0));
        QVERIFY(isIndependent(born.vx, born.vy));
        QVERIFY(isIndependent(born.vy, born.vz));
        QVERIFY(isIndependent(born.vx, born.vz));
        QVERIFY(isIndependent(born.vx, born.x));
    }

    void equationII_withoutRandomnessIsSpeedTimesNormal()
    {
        Effect effect = oneParticle();
        effect.emitter.speed = 2.5F;
        effect.emitter.normal = glm::vec3(0.6F, 0.0F, 0.8F);
        const glm::dvec3 v = Trail{effect}.velocity(0);
        QVERIFY(near(v.x, 1.5, 1e-6));
        QVERIFY(near(v.y, 0.0, 1e-6));
        QVERIFY(near(v.z, 2.0, 1e-6));
    }

    void equationIII_windAcceleratesAlongX()
    {
        Effect effect = oneParticle();
        effect.wind.strength = 1.5F;
        effect.wind.angle = 60.0F;
        const double t = 20.0 / 30.0;
        QVERIFY(near(Trail{effect}.velocity(20).x, 1.5 * 0.5 * t, 1e-5)); // Vw cos 60 t
    }

    void equationIV_gravityDividedByMassPullsDown()
    {
        Effect effect = oneParticle();
        effect.motion.gravity = 9.81F;
        effect.motion.mass = 4.0F;
        const double t = 30.0 / 30.0;
        QVERIFY(near(Trail{effect}.velocity(30).y, 1.0 - 9.81 / 4.0 * t, 1e-5));
    }

    void equationV_windAcceleratesAlongZ()
    {
        Effect effect = oneParticle();
        effect.wind.strength = 1.5F;
        effect.wind.angle = 60.0F;
        const double t = 20.0 / 30.0;
        QVERIFY(near(Trail{effect}.velocity(20).z, 1.5 * std::sqrt(0.75) * t, 1e-5)); // Vw sin 60 t
    }

    void equationIX_velocityIsTheSumOfAccelerations()
    {
        Effect effect = oneParticle();
        effect.wind.strength = 2.0F;
        const Trail trail{effect};
        for (const int frame : {1, 7, 25}) {
            QVERIFY(near(trail.velocity(frame).x, 2.0 * frame / 30.0, 1e-5));
        }
    }

    void equationX_positionUsesTheNewVelocity()
    {
        // Semi-implicit Euler: P(n) = sum of a dt k dt for k = 1..n = a dt^2 n (n + 1) / 2.
        Effect effect = oneParticle();
        effect.wind.strength = 2.0F;
        const Trail trail{effect};
        const double dt = 1.0 / 30.0;
        for (const int n : {1, 2, 30}) {
            QVERIFY(near(trail.position(n).x, 2.0 * dt * dt * n * (n + 1) / 2.0, 1e-5));
            QVERIFY(near(trail.position(n).y, n * dt, 1e-5));
        }
    }

    void equationXI_randomAccelerationIsUniform()
    {
        const Kicks kicks(randomForces(), 5);
        const double dt = 1.0 / 30.0;
        const double ax = 3.0 * std::cos(M_PI / 6.0) * dt;
        const double ay = 2.0 * dt;
        const double az = 3.0 * std::sin(M_PI / 6.0) * dt;
        QVERIFY(isUniform(kicks.x, -ax, ax));
        QVERIFY(isUniform(kicks.y, -ay, ay));
        QVERIFY(isUniform(kicks.z, -az, az));
    }

    void equationXI_drawsOfComponentsAreIndependent()
    {
        const Kicks kicks(randomForces(), 5);
        QVERIFY(isIndependent(kicks.x, kicks.y));
        QVERIFY(isIndependent(kicks.y, kicks.z));
        QVERIFY(isIndependent(kicks.x, kicks.z));
    }

    void equationXI_drawsOfStepsAreIndependent()
    {
        const Effect effect = randomForces();
        const Kicks first(effect, 5);
        for (const int later : {6, 7, 20}) {
            const Kicks second(effect, later);
            QVERIFY(isIndependent(first.x, second.x));
            QVERIFY(isIndependent(first.y, second.y));
            QVERIFY(isIndependent(first.x, second.y));
        }
    }

    void equationXI_neighboursAreIndependent()
    {
        const Kicks kicks(randomForces(), 5);
        const std::vector<float> these(kicks.x.begin(), kicks.x.end() - 1);
        const std::vector<float> next(kicks.x.begin() + 1, kicks.x.end());
        QVERIFY(isIndependent(these, next));
    }

    void equationXII_velocityIsARandomWalk()
    {
        // After n steps the variance is n (a dt)^2 / 3.
        const Effect effect = randomForces();
        const auto frame = frameOf(effect, 24);
        std::vector<float> vz(frame->particles.vz.begin(), frame->particles.vz.begin() + kMany);
        const Moments m = Moments::of(vz);
        const double step = 1.5 / 30.0;
        const double variance = 24.0 * step * step / 3.0;
        QVERIFY(near(m.mean, 0.0, kErrors * std::sqrt(variance / kMany)));
        QVERIFY(near(m.variance, variance, kErrors * variance * std::sqrt(2.0 / kMany)));
    }

    void equationXII_randomnessBlendsBetweenSteadyAndRandom()
    {
        Effect effect = randomForces();
        effect.motion.randomness = 0.25F;
        const Kicks kicks(effect, 3);
        const double a = 1.5 / 30.0; // along z
        QVERIFY(isUniform(kicks.z, a * 0.5, a * 1.0)); // a (1 - r + r rand())
    }

    void equationXIII_alphaFallsLinearly()
    {
        Effect effect = oneParticle();
        effect.life.initialAlpha = 0.1F;
        effect.life.fadeRate = 0.02F;
        for (const int n : {0, 1, 60, 149}) {
            const Lifecycle cycle = lifecycle(*frameOf(effect, n), 0);
            QVERIFY(cycle.alive);
            QVERIFY(near(cycle.alpha, 0.1 - 0.02 * n / 30.0, 1e-6));
        }
    }

    void equationXIII_lifetimeIsAlphaOverFadeToTheStep_data()
    {
        QTest::addColumn<float>("alpha");
        QTest::addColumn<float>("fade");
        QTest::addColumn<int>("steps");
        QTest::newRow("5 s") << 0.1F << 0.02F << 150;
        QTest::newRow("1 s") << 0.1F << 0.1F << 30;
        QTest::newRow("not whole") << 0.1F << 0.07F << 43; // 42.86
        QTest::newRow("one step") << 0.1F << 50.0F << 1;
    }
    void equationXIII_lifetimeIsAlphaOverFadeToTheStep()
    {
        QFETCH(float, alpha);
        QFETCH(float, fade);
        QFETCH(int, steps);
        Effect effect = oneParticle();
        effect.life.initialAlpha = alpha;
        effect.life.fadeRate = fade;
        QVERIFY(lifecycle(*frameOf(effect, steps - 1), 0).alive);
        QVERIFY(!lifecycle(*frameOf(effect, steps), 0).alive);
    }

    void equationXIII_populationIsConstantOnceWarm()
    {
        for (const int count : {1, 7, 1000, 1001, 4999}) {
            const Effect effect = thesisEffect(count);
            Simulator simulator(sampled(effect));
            for (const int number : {149, 150, 151, 299, 300, 777}) {
                const auto frame = simulator.frame(number).value();
                const int alive = livingCount(*frame);
                QCOMPARE(alive, count);
            }
        }
    }

    void equationXIII_populationGrowsLinearlyBefore()
    {
        const auto frame = frameOf(thesisEffect(3000), 74);
        const int alive = livingCount(*frame);
        QCOMPARE(alive, 1500); // half of the lifetime of 150 steps
    }

    void wholeBodyRotationTurnsTheCloudAboutTheEmitter()
    {
        Effect effect = oneParticle();
        effect.emitter.position = {1.0F, 0.0F, 0.0F};
        effect.emitter.normal = {1.0F, 0.0F, 0.0F};
        effect.motion.rotation = 90.0F;
        effect.timeline.frameRate = 30;
        // Velocity turns with the cloud, so the particle moves straight in the turning frame: after 1 s it lies 1 m
        // away at 90 degrees.
        const glm::dvec3 p = Trail{effect}.position(30);
        QVERIFY(near(p.x, 1.0, 1e-4));
        QVERIFY(near(p.y, 0.0, 1e-5));
        QVERIFY(near(p.z, -1.0, 1e-4));
    }

    void wholeBodyRotationJitterHasMeanZero()
    {
        Effect effect = thesisEffect(1);
        effect.motion.rotationJitter = 90.0F;
        const SimulationModel model(sampled(effect));
        std::vector<float> angles;
        for (int step = 0; step < kMany; ++step) {
            angles.push_back(model.rotationAt(step) * 180.0F / 3.14159265F * 30.0F);
        }
        QVERIFY(isUniform(angles, -90.0, 90.0));
    }

    void figure1_buoyancyCools()
    {
        // V(n) = b dt sum of exp(-c k dt), k = 1..n.
        Effect effect = oneParticle();
        effect.emitter.speed = 0.0F;
        effect.motion.buoyancy = effect.air.buoyancy = 2.0F;
        effect.motion.cooling = effect.air.cooling = 1.5F;
        const double dt = 1.0 / 30.0;
        const double q = std::exp(-1.5 * dt);
        QVERIFY(near(Trail{effect}.velocity(40).y, 2.0 * dt * q * (1.0 - std::pow(q, 40)) / (1.0 - q), 1e-4));
    }

    void dragSlowsExponentially()
    {
        Effect effect = oneParticle();
        effect.motion.drag = effect.air.drag = 0.7F;
        QVERIFY(near(Trail{effect}.velocity(45).y, std::exp(-0.7 * 1.5), 1e-5));
    }

    void ringsAreTheCurlOfTheirPotential()
    {
        const Effect effect = evenRings();
        constexpr int kStep = 30; // the first ring is 1.5 m up, the one that follows at 0.5 m
        for (const double rho : {0.0, 0.15, 0.4, 0.7, 1.0}) {
            for (const double height : {0.3, 0.55, 1.1, 1.5, 1.8}) {
                const double s2 = rho * rho / 0.16;
                const double arched = height + rho * rho / 0.8; // b = 1 / (2 R)
                const bool first = arched > 1.0;
                const double way = arched - (first ? 1.5 : 0.5);
                const double strength = (first ? 2.0 : 1.0) * (way < 0.5 ? 1.0 : 0.0);
                const double q = std::max(0.0, 1.0 - s2 / 5.0);
                const double flat = 1.0 - 4.0 * way * way;
                const double away = 8.0 * strength * rho * std::pow(q, 4) * way * flat;
                const double along = strength * std::pow(q, 3) * (q - 0.8 * s2) * flat * flat - 2.0 / 0.8 * rho * away;
                const glm::dvec3 v = carriedBy(effect, kStep, {glm::vec3(0.6 * rho, height, 0.8 * rho)}).front();
                QVERIFY(near(v.y, along, 2e-4));
                QVERIFY(near(0.6 * v.x + 0.8 * v.z, away, 2e-4));
                QVERIFY(near(0.8 * v.x - 0.6 * v.z, 0.0, 2e-4));
            }
        }
    }

    void ringsHaveNoDivergence()
    {
        constexpr float kHalf = 0.01F;
        for (const glm::vec3& at :
            {glm::vec3(0.2F, 0.3F, 0.1F), glm::vec3(0.3F, 0.8F, -0.2F), glm::vec3(-0.1F, 1.3F, 0.25F)}) {
            const auto v = carriedBy(evenRings(), 30,
                {at + glm::vec3(kHalf, 0, 0), at - glm::vec3(kHalf, 0, 0), at + glm::vec3(0, kHalf, 0),
                    at - glm::vec3(0, kHalf, 0), at + glm::vec3(0, 0, kHalf), at - glm::vec3(0, 0, kHalf)});
            const double divergence =
                (v[0].x - v[1].x + v[2].y - v[3].y + v[4].z - v[5].z) / (2.0 * static_cast<double>(kHalf));
            QVERIFY(near(divergence, 0.0, 0.02)); // of terms of about 5 / s
        }
    }

    void airBeforeTheFirstRingIsStill()
    {
        Effect effect = evenRings();
        effect.rings.variance = 1.0F;
        QCOMPARE(carriedBy(effect, 30, {glm::vec3(0.1F, 2.05F, 0.0F)}).front(), glm::dvec3(0.0));
        effect.timeline.prewarm = true; // warm smoke has rings all the way up
        QVERIFY(glm::length(carriedBy(effect, 30, {glm::vec3(0.1F, 2.4F, 0.0F)}).front()) > 0.01);
    }

    void particlesTurnAtHalfTheVorticity()
    {
        Effect effect = thesisEffect(1);
        effect.look.roll = 1.0F;
        effect.turbulence.strength = 1.0F;
        effect.turbulence.octaves = 2;
        effect.turbulence.onset = 0.0F;
        const SimulationModel model(sampled(effect));
        const StepConstants constants = model.constants(3);
        for (const glm::vec3& at :
            {glm::vec3(0.3F, 0.7F, -0.2F), glm::vec3(-0.8F, 1.4F, 0.5F), glm::vec3(0.05F, 0.2F, 0.9F)}) {
            Particles p;
            p.reset(1, {.rolls = true});
            p.x[0] = at.x;
            p.y[0] = at.y;
            p.z[0] = at.z;
            p.birthStep[0] = 0;
            stepChunk(constants, p, 0);
            constexpr float kHalf = 0.004F;
            const auto slope = [&](const glm::vec3& way) {
                const auto v = carriedBy(effect, 3, {at + kHalf * way, at - kHalf * way});
                return (v[0] - v[1]) / (2.0 * static_cast<double>(kHalf));
            };
            const glm::dvec3 dx = slope({1, 0, 0});
            const glm::dvec3 dy = slope({0, 1, 0});
            const glm::dvec3 dz = slope({0, 0, 1});
            const glm::dvec3 vorticity(dy.z - dz.y, dz.x - dx.z, dx.y - dy.x);
            const glm::dvec3 turned =
                glm::dvec3(p.rollX[0], p.rollY[0], p.rollZ[0]) / (0.5 * static_cast<double>(constants.dt));
            QVERIFY2(glm::length(turned - vorticity) < 0.03 * glm::length(vorticity),
                qPrintable(QString::number(glm::length(turned - vorticity) / glm::length(vorticity))));
        }
    }

    void vortexIsFastestAtItsRadius()
    {
        Effect effect = thesisEffect(1);
        effect.vortex.strength = 3.0F;
        effect.vortex.radius = 0.5F;
        const std::vector<glm::dvec3> v = carriedBy(
            effect, 1, {glm::vec3(0.25F, 0.0F, 0.0F), glm::vec3(0.5F, 0.0F, 0.0F), glm::vec3(1.0F, 0.0F, 0.0F)});
        const double dt = 1.0 / 30.0;
        const auto turned = [&](const glm::dvec3& moved, double radius) {
            return std::atan2(-moved.z * dt, radius + moved.x * dt) * radius / dt;
        };
        QVERIFY(near(turned(v[0], 0.25), 3.0 * 0.8, 1e-5)); // 2 s / (1 + s^2) at s = 1/2
        QVERIFY(near(turned(v[1], 0.5), 3.0, 1e-5));
        QVERIFY(near(turned(v[2], 1.0), 3.0 * 0.8, 1e-5));

        effect.vortex.widening = 0.25F; // twice as wide two metres above, and no narrower below
        const std::vector<glm::dvec3> funnel =
            carriedBy(effect, 1, {glm::vec3(1.0F, 2.0F, 0.0F), glm::vec3(0.5F, -2.0F, 0.0F)});
        QVERIFY(near(turned(funnel[0], 1.0), 3.0, 1e-5));
        QVERIFY(near(turned(funnel[1], 0.5), 3.0, 1e-5));
    }
};

QTEST_GUILESS_MAIN(ModelTest)
#include "model_test.moc"
