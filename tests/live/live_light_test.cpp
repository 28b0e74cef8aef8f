// The colour of smoke inside a game in its light, and the ways out of it.
#include "tests/live/counted_heap.h"
#include "tests/live/live_helpers.h"

#include "core/base/parallel.h"
#include "core/live/live_light.h"

#include <limits>

#include <glm/geometric.hpp>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr glm::vec3 kEye{1.0F, 2.0F, 8.0F};

/// Dense smoke as a game has it: no texture.
Effect dense(int count = 4000)
{
    Effect effect = windy(count);
    effect.look.texture = 0.0F;
    effect.look.opacity = 3.0F;
    effect.look.size = 0.3F;
    effect.light.resolution = 24;
    return effect;
}

Effect burning()
{
    Effect effect = dense();
    effect.glow.emission = 3.0F;
    effect.glow.emissionCooling = 0.5F;
    effect.glow.hotCore = 0.4F;
    effect.glow.flameOpacity = 0.5F;
    effect.glow.emissionColour = EmissionColour::BlackBody;
    return effect;
}

Effect burningInAir()
{
    Effect effect = inAir(3000);
    effect.look = dense().look;
    effect.glow = burning().glow;
    effect.air.resolution = 16;
    return effect;
}

/// Smoke that has been there for a while.
LiveSimulation settled(const Effect& effect, int steps = 90)
{
    LiveSimulation live = started(effect);
    go(live, steps);
    return live;
}

std::vector<glm::vec4> coloursOf(LiveSimulation& live, const std::optional<glm::vec3>& eye = std::nullopt)
{
    const std::span<const glm::vec4> colours = live.litColours(eye).value();
    return {colours.begin(), colours.end()};
}

double brightness(const glm::vec4& colour)
{
    return static_cast<double>(colour.r + colour.g + colour.b);
}

/// Mean brightness of the particles that are seen and that a condition holds for.
template <class Condition>
double meanWhere(LiveSimulation& live, const std::vector<glm::vec4>& colours, const Condition& holds)
{
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        if (live.appearance().radius[i] > 0.0F && holds(i)) {
            sum += brightness(colours[i]);
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : -1.0;
}

double meanOf(LiveSimulation& live, const std::vector<glm::vec4>& colours)
{
    return meanWhere(live, colours, [](std::size_t) { return true; });
}

} // namespace

class LiveLightTest : public QObject {
    Q_OBJECT

private slots:
    void coloursAreThoseOfTheSpritesToTheBit_data()
    {
        QTest::addColumn<Effect>("effect");
        QTest::newRow("smoke") << dense();
        QTest::newRow("fire") << burning();
        QTest::newRow("fire in air") << burningInAir();
    }

    void coloursAreThoseOfTheSpritesToTheBit()
    {
        QFETCH(Effect, effect);
        LiveSimulation live = settled(effect);
        View view = makeView(effect.camera, 0.0F, 256, 256);
        Renderer renderer;
        QVERIFY(renderer.prepare(live.frame(), live.sampledEffect(), view).ok());
        const std::vector<glm::vec4> colours = coloursOf(live, view.eye);
        std::size_t seen = 0;
        for (std::size_t i = 0; i < colours.size(); ++i) {
            if (renderer.batch().depth[i] == SpriteBatch::kHidden) {
                continue;
            }
            ++seen;
            const Sprite& sprite = renderer.batch().sprites[i];
            for (int channel = 0; channel < 3; ++channel) {
                QCOMPARE(colours[i][channel], sprite.direct[channel] + sprite.ambient[channel]);
            }
            QCOMPARE(colours[i].a, live.colours()[i].a);
        }
        QVERIFY(seen > 500);
    }

    void theSideInTheShadowIsDarker()
    {
        Effect effect = dense();
        effect.light.direction = {0.0F, -1.0F, 0.0F};
        LiveSimulation live = settled(effect);
        const std::vector<glm::vec4> colours = coloursOf(live);
        const Particles& at = live.particles();
        double middle = 0.0;
        for (std::size_t i = 0; i < colours.size(); ++i) {
            middle += static_cast<double>(at.y[i]) / static_cast<double>(live.living());
        }
        const auto isAbove = [&](std::size_t i) { return static_cast<double>(at.y[i]) > middle; };
        const double above = meanWhere(live, colours, isAbove);
        const double below = meanWhere(live, colours, [&](std::size_t i) { return !isAbove(i); });
        QVERIFY2(below > 0.0 && above > 1.3 * below, qPrintable(QStringLiteral("%1 %2").arg(above).arg(below)));
    }

    void withoutSunTheAmbientIsLeftAndWithoutThatNothing()
    {
        Effect effect = dense();
        effect.light.intensity = 0.0F;
        effect.light.occlusion = 0.0F;
        LiveSimulation live = settled(effect);
        const glm::vec3 ambient = effect.light.ambient * (effect.light.sky + effect.light.ground);
        std::size_t seen = 0;
        const std::vector<glm::vec4> colours = coloursOf(live);
        for (std::size_t i = 0; i < colours.size(); ++i) {
            const glm::vec4 unlit = live.colours()[i];
            const bool isSeen = live.appearance().radius[i] > 0.0F;
            seen += isSeen ? 1 : 0;
            for (int channel = 0; channel < 3; ++channel) {
                const float expected = isSeen ? unlit[channel] * ambient[channel] : 0.0F;
                QVERIFY(near(static_cast<double>(colours[i][channel]), static_cast<double>(expected), 1e-5));
            }
            QCOMPARE(colours[i].a, unlit.a);
        }
        QVERIFY(seen > 500);
        effect.light.ambient = 0.0F;
        QVERIFY(live.setEffect(effect).ok());
        QCOMPARE(meanOf(live, coloursOf(live)), 0.0);
    }

    void towardsTheSunSmokeIsBrighterAndWithoutAnEyeItIsEven()
    {
        Effect effect = dense();
        effect.light.anisotropy = 0.6F;
        LiveSimulation live = settled(effect);
        const auto from = [&](float far) { return meanOf(live, coloursOf(live, far * effect.light.direction)); };
        const double against = from(50.0F);
        const double along = from(-50.0F);
        const std::vector<glm::vec4> even = coloursOf(live);
        QVERIFY(along < meanOf(live, even) && meanOf(live, even) < against);
        effect.light.anisotropy = 0.0F;
        QVERIFY(live.setEffect(effect).ok());
        QCOMPARE(coloursOf(live, kEye), even);
    }

    void normalsLeadOutOfTheSmoke()
    {
        Effect effect = dense();
        effect.turbulence.strength = 0.0F;
        LiveSimulation live = settled(effect);
        (void)live.litColours(kEye).value();
        const std::span<const glm::vec3> normals = live.normals().value();
        const Particles& at = live.particles();
        glm::vec3 middle(0.0F);
        for (std::size_t i = 0; i < normals.size(); ++i) {
            middle += glm::vec3(at.x[i], at.y[i], at.z[i]) / static_cast<float>(live.living());
        }
        double out = 0.0;
        double count = 0.0;
        for (std::size_t i = 0; i < normals.size(); ++i) {
            const glm::vec3 way = glm::vec3(at.x[i], at.y[i], at.z[i]) - middle;
            if (live.appearance().radius[i] == 0.0F) {
                QCOMPARE(glm::length(normals[i]), 0.0F);
            } else if (glm::length(way) > 0.5F) {
                QVERIFY(near(static_cast<double>(glm::length(normals[i])), 1.0, 1e-5));
                out += static_cast<double>(glm::dot(normals[i], glm::normalize(way)));
                count += 1.0;
            }
        }
        QVERIFY2(count > 300.0 && out / count > 0.4, qPrintable(QString::number(out / count)));
    }

    void whatThrowsNoShadowHasNoWayOut()
    {
        Effect effect = dense();
        effect.light.shadow = 0.0F;
        effect.light.occlusion = 0.0F;
        effect.look.overlap = 1.0F;
        LiveSimulation live = settled(effect);
        const std::span<const glm::vec3> normals = live.normals().value();
        for (const glm::vec3& normal : normals) {
            QCOMPARE(glm::length(normal), 0.0F);
        }
    }

    void itIsFoundAnewAfterAStepAndAChange()
    {
        Effect effect = dense();
        LiveSimulation live = settled(effect);
        const std::vector<glm::vec4> before = coloursOf(live, kEye);
        QCOMPARE(coloursOf(live, kEye), before);
        go(live, 1);
        QVERIFY(coloursOf(live, kEye) != before);
        const double bright = meanOf(live, coloursOf(live, kEye));
        effect.look.colour *= 0.5F;
        QVERIFY(live.setEffect(effect).ok());
        QVERIFY(near(meanOf(live, coloursOf(live, kEye)), 0.5 * bright, 1e-4));
    }

    void itIsTheSameForAnyNumberOfThreads()
    {
        LiveSimulation live = settled(burning());
        const std::vector<glm::vec4> all = coloursOf(live, kEye);
        const std::span<const glm::vec3> ways = live.normals().value();
        const std::vector<glm::vec3> allWays(ways.begin(), ways.end());
        const ThreadLimit one(1);
        LiveLight alone;
        const std::span<const glm::vec4> colours = alone.colours(live.frame(), live.sampledEffect(), kEye).value();
        QVERIFY(std::equal(colours.begin(), colours.end(), all.begin(), all.end()));
        const std::span<const glm::vec3> normals = alone.normals(live.frame(), live.sampledEffect()).value();
        QVERIFY(std::equal(normals.begin(), normals.end(), allWays.begin(), allWays.end()));
    }

    void nobodyAndNowhere()
    {
        LiveSimulation live = started(dense());
        const auto isNothing = [](const auto& numbers) { return glm::length(numbers) == 0.0F; };
        const std::span<const glm::vec4> none = live.litColours().value();
        QCOMPARE(none.size(), live.particles().capacity);
        QVERIFY(std::all_of(none.begin(), none.end(), isNothing));
        const std::span<const glm::vec3> noWays = live.normals().value();
        QVERIFY(std::all_of(noWays.begin(), noWays.end(), isNothing));
        go(live, 60);
        const glm::vec3 nowhere(0.0F, std::numeric_limits<float>::quiet_NaN(), 0.0F);
        QCOMPARE(live.litColours(nowhere).error().code, ErrorCode::OutOfRange);
        QVERIFY(live.litColours(kEye).ok());
        Frame frame = live.frame();
        const auto lost =
            static_cast<std::size_t>(std::find_if(frame.particles.birthStep.begin(), frame.particles.birthStep.end(),
                                         [](std::int32_t step) { return step < 30; })
                - frame.particles.birthStep.begin());
        frame.particles.x[lost] = std::numeric_limits<float>::infinity();
        LiveLight light;
        QCOMPARE(light.colours(frame, live.sampledEffect(), kEye).error().code, ErrorCode::OutOfRange);
        QCOMPARE(light.normals(frame, live.sampledEffect()).error().code, ErrorCode::OutOfRange);
        QVERIFY(light.colours(live.frame(), live.sampledEffect(), kEye).ok());
    }

    void itAllocatesNothingWhereTheSmokeIsNoLargerThanBefore()
    {
#ifndef FUMAGE_LOOPS_ALLOCATE
        LiveSimulation live = settled(burning());
        const Frame early = live.frame();
        go(live, 60);
        LiveLight light;
        const auto both = [&] {
            for (const Frame* frame : {&early, &live.frame()}) {
                light.outdate();
                QVERIFY(light.colours(*frame, live.sampledEffect(), kEye).ok());
                QVERIFY(light.normals(*frame, live.sampledEffect()).ok());
            }
        };
        both();
        const std::size_t before = allocations();
        for (int i = 0; i < 10; ++i) {
            both();
        }
        QCOMPARE(allocations(), before);
#endif
    }
};

QTEST_GUILESS_MAIN(LiveLightTest)
#include "live_light_test.moc"
