// The same bits for any thread count and instruction set: frames, noise and pictures.

#include "tests/helpers.h"

#include "core/base/parallel.h"
#include "core/noise/texture.h"

using namespace fumage;
using namespace fumage::tests;

namespace {

/// Effects that together go through every kernel.
std::vector<Effect> effects()
{
    std::vector<Effect> out{everythingOn()};
    Effect burst = everythingOn();
    burst.emitter.shape = EmitterShape::Sphere;
    burst.emitter.mode = EmissionMode::Burst;
    burst.noise.basis = NoiseBasis::Simplex;
    burst.look.stretch = 0.0F;
    burst.output.viewTransform = ViewTransform::Filmic;
    out.push_back(burst);
    Effect thesis = thesisEffect(3000);
    thesis.wind.strength = 0.5F;
    thesis.motion.randomness = 1.0F;
    thesis.emitter.velocityRandomness = 1.0F;
    thesis.look.mask = MaskShape::Square;
    thesis.noise.basis = NoiseBasis::Lattice;
    thesis.noise.interpolation = Interpolation::Cubic;
    thesis.noise.smooth = 0.7F;
    thesis.output.width = 150;
    thesis.output.height = 70;
    out.push_back(thesis);
    Effect small = everythingOn();
    small.emitter.count = 20000;
    small.look.size = 0.05F;
    small.look.relief = 0.0F;
    small.look.roundness = 0.0F;
    small.light.resolution = 48;
    out.push_back(small);
    return out;
}

constexpr int kFrame = 33;

} // namespace

class SameBitsTest : public QObject {
    Q_OBJECT

private slots:
    void whateverTheThreads()
    {
        for (const Effect& effect : effects()) {
            const auto frame = frameOf(effect, kFrame);
            const Image image = render(effect, kFrame);
            for (const int threads : {1, 2, 7}) {
                const ThreadLimit limit(threads);
                QVERIFY(sameBits(frameOf(effect, kFrame)->particles, frame->particles));
                QVERIFY(sameBits(render(effect, kFrame).pixels, image.pixels));
            }
        }
    }

    void whateverTheInstructionSet()
    {
        const SimdGuard guard;
        for (const Effect& effect : effects()) {
            QVERIFY(forceSimdTarget("").ok());
            const auto frame = frameOf(effect, kFrame);
            const Image image = render(effect, kFrame);
            const NoiseTile tile = bakeNoise(effect.noise, 75, 0.37F).value();
            for (const std::string& name : availableSimdTargets()) {
                QVERIFY(forceSimdTarget(name).ok());
                QVERIFY2(sameBits(bakeNoise(effect.noise, 75, 0.37F).value().values, tile.values), name.c_str());
                QVERIFY2(sameBits(frameOf(effect, kFrame)->particles, frame->particles), name.c_str());
                QVERIFY2(sameBits(render(effect, kFrame).pixels, image.pixels), name.c_str());
            }
        }
    }
};

QTEST_GUILESS_MAIN(SameBitsTest)
#include "same_bits_test.moc"
