// Births on the bright pixels of a picture: where they are, how many, and that nothing but the picture decides it.

#include "tests/helpers.h"
#include "tests/pictures.h"

#include "core/base/parallel.h"
#include "core/flow/air.h"
#include "core/simulation/air_plan.h"

using namespace fumage;
using namespace fumage::tests;

namespace {

using Rgba = std::array<std::uint8_t, 4>;

constexpr int kColumns = 9;
constexpr int kRows = 7;

/// A third of it dark, the rest of any brightness and alpha.
Rgba scattered(int x, int y)
{
    const auto bits = static_cast<std::uint32_t>(x * 7 + y * 131) * 2654435761U;
    const auto grey = static_cast<std::uint8_t>(bits >> 24U);
    return {grey, grey, grey, static_cast<std::uint8_t>((x + y) % 3 == 0 ? 0 : 85 * (1 + (x + 2 * y) % 3))};
}

/// A burst on a rectangle of kColumns by kRows metres that lies level, before anything moves.
Effect onPicture(int count)
{
    Effect effect = thesisEffect(count);
    effect.emitter.shape = EmitterShape::Picture;
    effect.emitter.width = kColumns;
    effect.emitter.depth = kRows;
    effect.emitter.speed = 0.0F;
    effect.emitter.mode = EmissionMode::Burst;
    effect.emitter.burstDuration = 0.0F;
    effect.emitter.picture = pictureOf(kColumns, kRows, scattered);
    return effect;
}

struct Place {
    float across;
    float along;
};

std::vector<Place> birthsOf(const Effect& effect)
{
    const auto frame = frameOf(effect, 0);
    std::vector<Place> places;
    for (std::size_t i = 0; i < frame->particles.capacity; ++i) {
        if (frame->particles.birthStep[i] != Particles::kUnborn) {
            places.push_back({frame->particles.x[i], frame->particles.z[i]});
        }
    }
    return places;
}

/// How far counts are from what was expected, over the scatter of that if chance alone decides: 0 in the mean, with a
/// deviation of 1.
double surpriseOf(const std::vector<Place>& places)
{
    std::vector<int> counts(kColumns * kRows);
    for (const Place& place : places) {
        const int x = static_cast<int>(std::floor(place.across + 0.5F * kColumns));
        const int y = static_cast<int>(std::floor(place.along + 0.5F * kRows));
        counts.at(static_cast<std::size_t>(y * kColumns + x)) += 1;
    }
    double all = 0.0;
    std::vector<double> weights;
    for (int i = 0; i < kColumns * kRows; ++i) {
        const Rgba colour = scattered(i % kColumns, i / kColumns);
        weights.push_back(colour[0] * colour[3]);
        all += weights.back();
    }
    double chi2 = 0.0;
    int cells = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const double expected = weights[i] / all * static_cast<double>(places.size());
        if (expected == 0.0) {
            chi2 += counts[i] > 0 ? 1e9 : 0.0; // nothing is ever born where it is dark
        } else {
            chi2 += (counts[i] - expected) * (counts[i] - expected) / expected;
            ++cells;
        }
    }
    const double freedom = cells - 1;
    return (chi2 - freedom) / std::sqrt(2.0 * freedom);
}

Effect inAir(const Bitmap& picture)
{
    Effect effect = thesisEffect(4000);
    effect.emitter.shape = EmitterShape::Picture;
    effect.emitter.picture = picture;
    effect.emitter.position.y = 0.5F;
    effect.emitter.width = 2.0F;
    effect.emitter.depth = 1.0F;
    effect.air.enabled = true;
    effect.air.resolution = 32;
    effect.air.turbulence = 0.0F;
    effect.source.raggedness = 0.0F;
    effect.source.unevenness = 0.0F;
    return effect;
}

AirFieldPtr airOf(const Effect& effect, int step)
{
    const SampledEffect whole = sampled(effect);
    return BakedAir(airPlan(whole)).field(step).value();
}

Bitmap brightRight()
{
    return pictureOf(64, 64, [](int x, int /*y*/) {
        const auto grey = static_cast<std::uint8_t>(x < 32 ? 0 : 255);
        return Rgba{grey, grey, grey, 255};
    });
}

} // namespace

class PictureEmitterTest : public QObject {
    Q_OBJECT

private slots:
    void pixelsHaveAsManyBirthsAsTheyAreBrightAndOpaque()
    {
        // Chance leaves these bounds once in a few million.
        for (const std::uint32_t seed : {1U, 2U, 3U, 99U}) {
            Effect effect = onPicture(60000);
            effect.emitter.seed = seed;
            const std::vector<Place> places = birthsOf(effect);
            QCOMPARE(places.size(), std::size_t{60000});
            const double surprise = surpriseOf(places);
            qInfo("%.2f", surprise);
            QVERIFY(std::abs(surprise) < 5.0);
        }
    }

    void draftAndFinalHaveTheSameShares()
    {
        for (const Quality quality : {Quality::Draft, Quality::Final}) {
            Effect effect = onPicture(20000);
            effect.output.quality = quality;
            const std::vector<Place> places = birthsOf(effect);
            QCOMPARE(places.size(), std::size_t(quality == Quality::Draft ? 5000 : 160000));
            QVERIFY(std::abs(surpriseOf(places)) < 5.0);
        }
    }

    void birthsFillTheirPixelEvenly()
    {
        std::vector<float> across;
        std::vector<float> along;
        for (const Place& place : birthsOf(onPicture(60000))) {
            across.push_back(place.across + 0.5F * kColumns - std::floor(place.across + 0.5F * kColumns));
            along.push_back(place.along + 0.5F * kRows - std::floor(place.along + 0.5F * kRows));
        }
        const double deviation = std::sqrt(1.0 / 12.0 / 60000.0);
        for (const std::vector<float>& shares : {across, along}) {
            QVERIFY(near(Moments::of(shares).mean, 0.5, 5.0 * deviation));
            QVERIFY(near(Moments::of(shares).variance, 1.0 / 12.0, 0.002));
        }
        QVERIFY(std::abs(correlation(across, along)) < 5.0 / std::sqrt(60000.0));
    }

    void aPictureOnAWallStandsUprightAndIsNoMirrorImage()
    {
        Effect effect = onPicture(1000);
        effect.emitter.normal = {0.0F, 0.0F, 1.0F};
        effect.emitter.picture = pictureOf(2, 2, [](int x, int y) {
            return x == 1 && y == 0 ? Rgba{255, 255, 255, 255} : Rgba{0, 0, 0, 255}; // on the right at the top
        });
        const auto frame = frameOf(effect, 0);
        for (std::size_t i = 0; i < 1000; ++i) {
            QVERIFY(frame->particles.x[i] >= 0.0F && frame->particles.x[i] <= 0.5F * kColumns);
            QVERIFY(frame->particles.y[i] >= 0.0F && frame->particles.y[i] <= 0.5F * kRows);
            QVERIFY(std::abs(frame->particles.z[i]) < 1e-5F);
        }
    }

    void withoutAPictureThatIsBrightAllOfTheRectangleGivesBirth()
    {
        Effect effect = onPicture(3000);
        Effect rectangle = effect;
        rectangle.emitter.shape = EmitterShape::Rectangle;
        for (const Bitmap& picture : {Bitmap(), pictureOf(3, 3, [](int, int) { return Rgba{0, 0, 0, 255}; })}) {
            effect.emitter.picture = picture;
            QVERIFY(sameBits(frameOf(effect, 4)->particles, frameOf(rectangle, 4)->particles));
        }
    }

    void onlyWhatIsBornOnThePictureLooksAtIt()
    {
        Effect effect = everythingOn();
        const auto before = frameOf(effect, 5);
        effect.emitter.picture = ramp(5, 5);
        QVERIFY(sameBits(frameOf(effect, 5)->particles, before->particles));
    }

    void thePictureDecidesPlacesAndNothingElse()
    {
        Effect effect = onPicture(3000);
        effect.emitter.speed = 1.0F;
        effect.emitter.spread = 40.0F;
        Effect rectangle = effect;
        rectangle.emitter.shape = EmitterShape::Rectangle;
        const auto a = frameOf(effect, 0);
        const auto b = frameOf(rectangle, 0);
        QVERIFY(sameBits(a->particles.vx, b->particles.vx) && sameBits(a->particles.vy, b->particles.vy)
            && sameBits(a->particles.vz, b->particles.vz) && sameBits(a->particles.key, b->particles.key));
    }

    void theBitsAreTheSameForAnyThreadsAndInstructionSet()
    {
        const SimdGuard guard;
        for (const Effect& effect : {onPicture(20011), inAir(pictureOf(kColumns, kRows, scattered))}) {
            const auto frame = frameOf(effect, 6);
            for (const int threads : {1, 2, 7}) {
                const ThreadLimit limit(threads);
                QVERIFY(sameBits(frameOf(effect, 6)->particles, frame->particles));
            }
            for (const std::string& name : availableSimdTargets()) {
                QVERIFY(forceSimdTarget(name).ok());
                QVERIFY2(sameBits(frameOf(effect, 6)->particles, frame->particles), name.c_str());
            }
        }
    }

    // --- in air -----------------------------------------------------------------------------------------------------

    void inAirTheBornStayOnTheirPixels()
    {
        // Bright from 0.5 m on; drawn together to the middle they would begin far before.
        const auto frame = frameOf(inAir(pictureOf(64, 64,
                                       [](int x, int /*y*/) {
                                           const auto grey = static_cast<std::uint8_t>(x < 48 ? 0 : 255);
                                           return Rgba{grey, grey, grey, 255};
                                       })),
            1);
        int born = 0;
        for (std::size_t i = 0; i < frame->particles.capacity; ++i) {
            if (frame->particles.birthStep[i] != Particles::kUnborn) {
                QVERIFY(frame->particles.x[i] > 0.45F); // less what the air has moved it by since
                ++born;
            }
        }
        QVERIFY(born > 10);
    }

    void theSourceIsHotWhereThePictureIsBrightAndNowhereElse()
    {
        const Effect effect = inAir(brightRight());
        const auto field = airOf(effect, 3);
        float dark = 0.0F;
        float bright = 0.0F;
        for (const float z : {-0.3F, 0.0F, 0.3F}) {
            const float y = effect.emitter.position.y + 0.1F;
            dark = std::max(dark, field->at({-0.6F, y, z}).w);
            bright = std::max(bright, field->at({0.6F, y, z}).w);
        }
        QVERIFY(dark < 0.02F);
        QVERIFY(bright > 0.5F);
    }

    void aWhitePictureIsARectangleToTheAir()
    {
        const Effect white = inAir(pictureOf(3, 2, [](int, int) { return Rgba{255, 255, 255, 255}; }));
        Effect rectangle = white;
        rectangle.emitter.shape = EmitterShape::Rectangle;
        QVERIFY(sameBits(airOf(white, 5)->quads, airOf(rectangle, 5)->quads));
    }
};

QTEST_GUILESS_MAIN(PictureEmitterTest)
#include "picture_emitter_test.moc"
