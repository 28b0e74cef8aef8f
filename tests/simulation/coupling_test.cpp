// Particles that are dragged through the air, or that no air touches.

#include "tests/helpers.h"
#include "tests/simulation/flying.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr float kGravity = 9.81F;

template <class Visit>
void forLiving(const Particles& particles, const Visit& visit)
{
    for (std::size_t i = 0; i < particles.capacity; ++i) {
        if (particles.birthStep[i] != Particles::kUnborn) {
            visit(i);
        }
    }
}

} // namespace

class CouplingTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsFreeFalls()
    {
        Effect effect = flying(Coupling::Free);
        effect.motion.gravity = kGravity;
        effect.wind.strength = 5.0F; // blows it nowhere
        Simulator simulator(sampled(effect));
        const auto before = simulator.frame(3).value();
        const auto now = simulator.frame(4).value();
        const auto after = simulator.frame(5).value();
        const double dt = 1.0 / effect.timeline.frameRate;
        int seen = 0;
        forLiving(now->particles, [&](std::size_t i) {
            const auto bend = [&](const auto& column) {
                return static_cast<double>(column(*after)) - 2.0 * static_cast<double>(column(*now))
                    + static_cast<double>(column(*before));
            };
            QVERIFY(near(bend([&](const Frame& f) { return f.particles.y[i]; }), -kGravity * dt * dt, 2e-6));
            QVERIFY(near(bend([&](const Frame& f) { return f.particles.x[i]; }), 0.0, 2e-6));
            QCOMPARE(now->particles.heat[i], 1.0F);
            ++seen;
        });
        QVERIFY(seen > 250);
    }

    void stillAirSlowsWhatIsDragged()
    {
        Effect effect = flying(Coupling::Dragged);
        effect.motion.drag = 2.5F;
        Simulator simulator(sampled(effect));
        const auto now = simulator.frame(4).value();
        const auto after = simulator.frame(5).value();
        const double kept = std::exp(-2.5 / effect.timeline.frameRate);
        forLiving(now->particles, [&](std::size_t i) {
            QVERIFY(near(
                static_cast<double>(after->particles.vy[i]), static_cast<double>(now->particles.vy[i]) * kept, 1e-5));
        });
    }

    void windTakesWhatIsDraggedAlong()
    {
        Effect effect = flying(Coupling::Dragged);
        effect.motion.drag = 6.0F;
        effect.wind.strength = 2.0F;
        effect.wind.gust = 0.0F;
        effect.air.drag = 1.0F;
        const auto late = frameOf(effect, 60);
        forLiving(late->particles, [&](std::size_t i) {
            QVERIFY(near(static_cast<double>(late->particles.vx[i]), 2.0, 0.02)); // acceleration over drag
        });
    }

    void whatFallsBounces_data()
    {
        QTest::addColumn<float>("restitution");
        QTest::addColumn<float>("friction");
        QTest::newRow("half") << 0.5F << 0.0F;
        QTest::newRow("all") << 1.0F << 0.0F;
        QTest::newRow("sticks") << 0.0F << 1.0F;
    }
    void whatFallsBounces()
    {
        QFETCH(float, restitution);
        QFETCH(float, friction);
        Effect effect = flying(Coupling::Free);
        effect.motion.gravity = kGravity;
        effect.motion.restitution = restitution;
        effect.motion.friction = friction;
        Simulator simulator(sampled(effect));
        auto before = simulator.frame(0).value();
        int touches = 0;
        for (int number = 1; number < 90; ++number) {
            const auto now = simulator.frame(number).value();
            forLiving(now->particles, [&](std::size_t i) {
                QVERIFY(now->particles.y[i] >= effect.air.groundHeight);
                const bool isTouched = before->particles.birthStep[i] == now->particles.birthStep[i]
                    && now->particles.y[i] == effect.air.groundHeight;
                if (isTouched) {
                    const double into = static_cast<double>(before->particles.vy[i])
                        - static_cast<double>(kGravity) / effect.timeline.frameRate;
                    QVERIFY(near(
                        static_cast<double>(now->particles.vy[i]), -static_cast<double>(restitution) * into, 1e-4));
                    QVERIFY(near(static_cast<double>(now->particles.vx[i]),
                        static_cast<double>(before->particles.vx[i] * (1.0F - friction)), 1e-5));
                    ++touches;
                }
            });
            before = now;
        }
        QVERIFY(touches > 100);
    }

    /// Neither obstacle is ever entered, and the bits depend on neither threads nor instruction sets.
    void obstaclesAreKeptOutOf_data()
    {
        QTest::addColumn<int>("obstacle");
        QTest::addColumn<int>("coupling");
        for (const Coupling coupling : {Coupling::Dragged, Coupling::Free}) {
            const char* name = coupling == Coupling::Free ? "free" : "dragged";
            QTest::addRow("box, %s", name) << static_cast<int>(Obstacle::Box) << static_cast<int>(coupling);
            QTest::addRow("ball, %s", name) << static_cast<int>(Obstacle::Sphere) << static_cast<int>(coupling);
        }
    }
    void obstaclesAreKeptOutOf()
    {
        QFETCH(int, obstacle);
        QFETCH(int, coupling);
        Effect effect = everythingOn();
        effect.air.enabled = true;
        effect.air.resolution = kMinAirResolution;
        effect.air.obstacle = static_cast<Obstacle>(obstacle);
        effect.air.obstaclePosition = {0.1F, 0.8F, 0.0F};
        effect.motion.coupling = static_cast<Coupling>(coupling);
        effect.motion.gravity = 3.0F;
        effect.emitter.speed = 4.0F;
        effect.timeline.prewarm = false;
        const auto expected = frameOf(effect, 25);
        const glm::vec3 half = 0.5F * effect.air.obstacleSize;
        forLiving(expected->particles, [&](std::size_t i) {
            const Particles& p = expected->particles;
            const glm::vec3 away = glm::vec3(p.x[i], p.y[i], p.z[i]) - effect.air.obstaclePosition;
            const glm::vec3 inside = half - glm::abs(away);
            constexpr float kRounding = 1e-4F;
            const bool isInside = effect.air.obstacle == Obstacle::Box
                ? std::min({inside.x, inside.y, inside.z}) > kRounding
                : glm::length(away) < half.x - kRounding;
            QVERIFY(!isInside);
        });
        for (const std::string& target : availableSimdTargets()) {
            QVERIFY(forceSimdTarget(target).ok());
            for (const int threads : {1, 7}) {
                const ThreadLimit limit(threads);
                QVERIFY2(sameBits(frameOf(effect, 25)->particles, expected->particles), target.c_str());
            }
        }
        QVERIFY(forceSimdTarget("").ok());
    }
};

QTEST_GUILESS_MAIN(CouplingTest)
#include "coupling_test.moc"
