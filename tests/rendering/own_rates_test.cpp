// Spin and the boiling of particles that change over time: summed up over the life of each.

#include "tests/helpers.h"
#include "tests/scene/scene_pictures.h"

#include "core/effect/known_parameter.h"
#include "core/effect/parameter_table.h"
#include "core/rendering/camera.h"

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kFrame = 24;
constexpr double kSeconds = 24.0 / 30.0;

/// One particle that is born at frame 0 and stays where it is.
Effect loneParticle()
{
    Effect effect = thesisEffect(1);
    effect.emitter.mode = EmissionMode::Burst;
    effect.emitter.burstDuration = 0.0F;
    effect.emitter.speed = 0.0F;
    effect.emitter.width = effect.emitter.depth = 0.0F;
    effect.look.size = 0.5F;
    effect.look.spinVariance = 0.0F;
    effect.look.deformation = 0.0F;
    effect.look.mask = MaskShape::Square;
    effect.camera.target = {0.0F, 0.0F, 0.0F};
    effect.output.width = effect.output.height = 96;
    return effect;
}

Sprite spriteOf(const Effect& effect, const Tracks& tracks = {})
{
    const SampledEffect whole = sampled(effect, tracks);
    Simulator simulator(whole);
    Renderer renderer;
    const Status status = renderer.prepare(*simulator.frame(kFrame).value(), whole.atFrame(kFrame),
        makeView(effect.camera, 0.0F, effect.output.width, effect.output.height));
    if (!status) {
        qFatal("%s", status.error().text().c_str());
    }
    return renderer.batch().sprites[0];
}

Tracks ramp(const Parameter& row, float end, double seconds)
{
    Tracks tracks;
    tracks.set(Track{&row, {{0.0, 0.0F, Ease::Linear}, {seconds, end}}});
    return tracks;
}

bool sameTurn(const Sprite& a, const Sprite& b, float most)
{
    const float size = std::abs(b.m00) + std::abs(b.m01);
    return std::abs(a.m00 - b.m00) + std::abs(a.m01 - b.m01) + std::abs(a.m10 - b.m10) + std::abs(a.m11 - b.m11)
        < most * size;
}

} // namespace

class OwnRatesTest : public QObject {
    Q_OBJECT

private slots:
    void theAngleUnderARampOfSpinIsQuadratic()
    {
        Effect effect = loneParticle();
        const Tracks tracks = ramp(knownParameter("look.spin"), 300.0F, 2.0);
        const double angle = 0.5 * 300.0 / 2.0 * kSeconds * kSeconds; // 48 degrees
        effect.look.spin = static_cast<float>(angle / kSeconds);
        const Sprite turned = spriteOf(effect);
        effect.look.spin = 0.0F;
        QVERIFY(sameTurn(spriteOf(effect, tracks), turned, 1e-4F));
        QVERIFY(!sameTurn(spriteOf(effect), turned, 0.1F));
    }

    void eachParticleHasItsShareOfTheVariation()
    {
        Effect effect = loneParticle();
        effect.look.spin = 40.0F;
        const Tracks tracks = ramp(knownParameter("look.spin_variance"), 500.0F, 1.0);
        effect.look.spinVariance = static_cast<float>(0.5 * 500.0 * kSeconds);
        const Sprite turned = spriteOf(effect);
        effect.look.spinVariance = 0.0F;
        QVERIFY(sameTurn(spriteOf(effect, tracks), turned, 1e-4F));
        QVERIFY(!sameTurn(spriteOf(effect), turned, 0.01F));
    }

    void theNoiseGoesThroughTheIntegralOfItsRate()
    {
        Effect effect = loneParticle();
        effect.look.texture = 1.0F;
        effect.noise.slices = 32;
        effect.noise.depth = 8.0F;
        const Tracks tracks = ramp(knownParameter("look.texture_rate"), 8.0F, 1.0);
        effect.look.textureRate = static_cast<float>(0.5 * 8.0 * kSeconds);
        const Sprite boiled = spriteOf(effect);
        effect.look.textureRate = 0.0F;
        QCOMPARE(spriteOf(effect, tracks).texture, boiled.texture);
        QVERIFY(spriteOf(effect).texture != boiled.texture);
    }

    void whatWasBornLaterHasTurnedLess()
    {
        // A spin that ends at a key: older particles keep what they have, younger ones never turn.
        Tracks tracks;
        const Parameter& row = knownParameter("look.spin");
        tracks.set(Track{&row, {{0.0, 90.0F, Ease::Hold}, {0.5, 0.0F}}});
        Schedule schedule = makeSchedule(sampled(thesisEffect(100)));
        std::vector<float> sums;
        sumOverAges(*tracks.find(row), schedule, thesisEffect(100).timeline, kFrame, 1.0F, sums);
        QCOMPARE(sums.size(), static_cast<std::size_t>(kFrame) + 2);
        for (int age = 0; age <= kFrame; ++age) {
            const double born = (kFrame - age) / 30.0;
            QVERIFY(
                near(static_cast<double>(sums[static_cast<std::size_t>(age)]), 90.0 * std::max(0.0, 0.5 - born), 1e-3));
        }
    }

    void aFrameIsTheSameForAllInstructionSets()
    {
        Scene scene = everythingOn();
        for (const char* key : {"look.spin", "look.spin_variance", "look.texture_rate"}) {
            const Parameter& row = *findParameter(key);
            scene.tracksOf(row, 0).set(Track{&row, {{0.0, 0.0F, Ease::Linear}, {0.5, 3.0F}, {1.0, 90.0F}}});
        }
        const Image expected = pictureOf(scene, 9);
        for (const std::string& target : availableSimdTargets()) {
            QVERIFY(forceSimdTarget(target).ok());
            QVERIFY2(tests::sameBits(pictureOf(scene, 9).pixels, expected.pixels), target.c_str());
        }
        QVERIFY(forceSimdTarget("").ok());
    }
};

QTEST_GUILESS_MAIN(OwnRatesTest)
#include "own_rates_test.moc"
