#include "tests/helpers.h"

#include "core/effect/sampling.h"

#include <cmath>
#include <type_traits>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// Mean alpha of a small picture.
double coverage(const Effect& effect)
{
    Renderer renderer;
    Image image;
    [&] { QVERIFY(renderer.render(*frameOf(effect, 20), sampled(effect), 96, 96, image)); }();
    double sum = 0.0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            sum += static_cast<double>(image.at(x, y).a);
        }
    }
    return sum / (96.0 * 96.0);
}

template <class T>
concept CanBeSampled = requires(const T& effect)
{
    sampled(effect);
};

} // namespace

class SamplingTest : public QObject {
    Q_OBJECT

private slots:
    void goodChangesNothing()
    {
        const Effect effect;
        QVERIFY(sampled(effect) == effect);
        QVERIFY(SampledEffect() == effect);
    }

    void qualityIsWorkedInOnce()
    {
        static_assert(CanBeSampled<Effect> && !CanBeSampled<SampledEffect>);
        static_assert(!std::is_constructible_v<SampledEffect, Effect>);
        static_assert(!std::is_constructible_v<SimulationModel, Effect> && !std::is_constructible_v<Simulator, Effect>);
        for (const Quality quality : {Quality::Draft, Quality::Final}) {
            Effect effect;
            effect.output.quality = quality;
            QVERIFY(sampled(effect)->output.quality == Quality::Good);
        }
    }

    void densityStays()
    {
        Effect effect;
        const auto density = [](const Effect& e) {
            return static_cast<double>(e.emitter.count)
                * static_cast<double>(e.look.size * e.look.size * e.look.opacity);
        };
        for (const Quality quality : {Quality::Draft, Quality::Final}) {
            effect.output.quality = quality;
            const SampledEffect other = sampled(effect);
            QCOMPARE(other->emitter.count, quality == Quality::Final ? 800000 : 25000);
            QVERIFY(std::abs(density(other) / density(effect) - 1.0) < 1e-4);
        }
    }

    void lightKeepsItsCells()
    {
        Effect effect;
        for (const Quality quality : {Quality::Draft, Quality::Final}) {
            effect.output.quality = quality;
            QVERIFY(sampled(effect)->light == effect.light);
        }
    }

    void countsStayInTheirRange()
    {
        Effect effect;
        effect.output.quality = Quality::Final;
        effect.emitter.count = kMaxParticles - 1;
        QCOMPARE(sampled(effect)->emitter.count, kMaxParticles);
        effect.output.quality = Quality::Draft;
        effect.emitter.count = 1;
        QCOMPARE(sampled(effect)->emitter.count, 1);
    }

    void pictureKeepsItsDensity()
    {
        Effect effect;
        effect.emitter.count = 40000;
        const double good = coverage(effect);
        for (const Quality quality : {Quality::Draft, Quality::Final}) {
            effect.output.quality = quality;
            QVERIFY2(
                std::abs(coverage(effect) / good - 1.0) < 0.08, qPrintable(QString::number(coverage(effect) / good)));
        }
    }

    void thinnedSmokeCoversAsMuch()
    {
        const Effect effect;
        const auto cover = [](const Effect& e) {
            return static_cast<double>(e.emitter.count) * static_cast<double>(e.look.size * e.look.size);
        };
        QVERIFY(std::abs(cover(thinned(sampled(effect), 1000)) / cover(effect) - 1.0) < 1e-4);
        QVERIFY(thinned(sampled(effect), effect.emitter.count) == effect);
    }

    void thinnedHasWhatIsAskedFor()
    {
        Effect effect;
        effect.output.quality = Quality::Final;
        const SampledEffect few = thinned(sampled(effect), 1000);
        QCOMPARE(few->emitter.count, 1000);
        QVERIFY(few->output.quality == Quality::Good);
    }
};

QTEST_GUILESS_MAIN(SamplingTest)
#include "sampling_test.moc"
