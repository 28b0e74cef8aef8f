#include "tests/helpers.h"
#include "tests/lighting/clouds.h"

#include "core/base/hash.h"
#include "core/effect/sampling.h"
#include "core/lighting/appearance.h"
#include "core/lighting/black_body.h"
#include "core/lighting/light_grid.h"
#include "core/lighting/overlap.h"

#include <array>
#include <cmath>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// Extinction times volume, summed over the grid.
double crossSection(const LightGrid& grid)
{
    double sum = 0.0;
    for (const float density : grid.density) {
        sum += static_cast<double>(density);
    }
    return sum * std::pow(static_cast<double>(grid.shape.cell), 3.0);
}

/// Luminance of a picture over its alpha.
double lightOfSmoke(const Effect& effect)
{
    const Image image = render(effect, 30);
    double light = 0.0;
    double alpha = 0.0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const glm::vec4 pixel = image.at(x, y);
            light += static_cast<double>(0.2126F * pixel.r + 0.7152F * pixel.g + 0.0722F * pixel.b);
            alpha += static_cast<double>(pixel.a);
        }
    }
    return light / alpha;
}

/// Appearance of a cloud before and after its lone particles have grown.
struct Grown {
    Lit lit;
    Appearance after;

    Grown(const Frame& frame, Effect effect, float overlap)
        : lit(frame, (effect.look.overlap = overlap, effect))
        , after(lit.appearance)
    {
        OverlapWorkspace room;
        inflateSparseParticles(frame, sampled(effect), lit.grid, room, after);
    }

    [[nodiscard]] double growthOf(std::size_t i) const
    {
        return static_cast<double>(after.radius[i]) / static_cast<double>(lit.appearance.radius[i]);
    }
};

} // namespace

class LightingTest : public QObject {
    Q_OBJECT

private slots:
    void aLoneParticleGrowsAndCoversAsMuchAsBefore()
    {
        const Effect effect = lookInSun();
        // Far from the others, wherever in its cell it lies.
        for (const float x : {3.0F, 3.017F, 3.05F}) {
            std::vector<glm::vec3> places = box(8);
            places.emplace_back(x, 0.4F, 0.2F);
            const Grown grown(cloud(effect, places), effect, 8.0F);
            const std::size_t lone = places.size() - 1;
            QVERIFY2(near(grown.growthOf(lone), 2.0, 0.02),
                qPrintable(QString::number(grown.growthOf(lone)))); // the cube root of 8
            const auto covered = [&](const Appearance& of) {
                return static_cast<double>(of.alpha[lone] * of.radius[lone] * of.radius[lone]);
            };
            QVERIFY(near(covered(grown.after), covered(grown.lit.appearance), 1e-5));
        }
    }

    void aParticleGrowsByWhatItsNeighboursLack()
    {
        // At random in a cube of 1 m; 4/3 pi r^3 9000 with r = 0.1 are 37.7 others that overlap one.
        constexpr std::size_t kCount = 9000;
        std::vector<glm::vec3> places;
        for (std::uint32_t i = 0; i < kCount; ++i) {
            places.emplace_back(unitFloat(streamBits(i, 1)), unitFloat(streamBits(i, 2)), unitFloat(streamBits(i, 3)));
        }
        Effect effect = lookInSun();
        for (const float opacity : {5.0F, 0.5F, 0.05F}) { // finer and finer cells
            effect.look.opacity = opacity;
            const Frame frame = cloud(effect, places);
            constexpr double kOverlap = 64.0;
            const Grown grown(frame, effect, static_cast<float>(kOverlap));
            double sum = 0.0;
            double inside = 0.0;
            for (std::size_t i = 0; i < kCount; ++i) {
                const glm::vec3 off = glm::abs(places[i] - 0.5F);
                if (std::max({off.x, off.y, off.z}) < 0.2F) {
                    sum += kOverlap / std::pow(grown.growthOf(i), 3.0) - 1.0;
                    inside += 1.0;
                }
            }
            const double others = sum / inside;
            qInfo("opacity %g: %.1f others", static_cast<double>(opacity), others);
            QVERIFY(std::abs(others / 37.7 - 1.0) < 0.1);
            const Grown crowded(frame, effect, 4.0F);
            const auto still = std::count_if(places.begin(), places.end(), [&](const glm::vec3& place) {
                return crowded.growthOf(static_cast<std::size_t>(&place - places.data())) == 1.0;
            });
            QVERIFY(static_cast<double>(still) > 0.98 * static_cast<double>(kCount));
        }
    }

    void withoutOverlapNothingGrows()
    {
        const Effect effect = lookInSun();
        const Grown grown(cloud(effect, {{0.0F, 0.0F, 0.0F}, {3.0F, 0.0F, 0.0F}}), effect, 0.0F);
        QCOMPARE(grown.growthOf(0), 1.0);
        QCOMPARE(grown.growthOf(1), 1.0);
    }

    void appearanceFollowsTheLifecycle()
    {
        Effect effect = everythingOn();
        effect.life.alphaCurve = Curve{{0.0F, 1.0F}};
        effect.life.sizeCurve = Curve{{0.0F, 1.0F}};
        effect.look.dilution = 0.0F;
        effect.look.opacity = 1.0F;
        effect.glow.flameOpacity = 1.0F;
        const auto frame = frameOf(effect, 13);
        Appearance appearance;
        findAppearance(*frame, sampled(effect), Axes{}, appearance);
        for (std::size_t i = 0; i < frame->particles.capacity; ++i) {
            const Lifecycle cycle = lifecycle(*frame, i);
            QCOMPARE(appearance.life[i], cycle.life);
            QCOMPARE(appearance.alpha[i], cycle.alpha);
            QCOMPARE(appearance.radius[i] > 0.0F, cycle.alpha > 0.0F);
        }
    }

    void dilutionKeepsTheAmountOfSmoke()
    {
        Effect effect = thesisEffect(2000);
        effect.timeline.prewarm = true;
        effect.life.sizeCurve = Curve{{0.0F, 0.25F}, {1.0F, 1.0F}};
        effect.life.alphaCurve = Curve{{0.0F, 1.0F}};
        effect.look.sizeVariance = 0.0F;
        effect.look.opacity = 2.0F;
        effect.look.dilution = 1.0F;
        const auto frame = frameOf(effect, 0);
        Appearance appearance;
        findAppearance(*frame, sampled(effect), Axes{}, appearance);
        for (std::size_t i = 0; i < frame->particles.capacity; ++i) {
            const Lifecycle cycle = lifecycle(*frame, i);
            const float smoke =
                appearance.alpha[i] * appearance.radius[i] * appearance.radius[i] / (2.0F * cycle.alpha);
            QVERIFY(std::abs(smoke / (0.25F * 0.25F * 0.25F * effect.look.size * effect.look.size) - 1.0F) < 0.02F);
        }
    }

    void smokeFadesInAboveTheGround()
    {
        Effect effect = lookInSun();
        effect.air.groundHeight = 0.5F;
        std::vector<glm::vec3> places;
        for (const float height : {-4.0F, 0.0F, 0.5F, 1.0F, 1.5F, 2.0F, 2.5F, 9.0F}) {
            places.emplace_back(0.3F, height, 0.1F);
        }
        const Frame frame = cloud(effect, places);
        const auto alphas = [&](float fade) {
            effect.look.groundFade = fade;
            Appearance appearance;
            findAppearance(frame, sampled(effect), Axes{}, appearance);
            return std::vector<float>(
                appearance.alpha.begin(), appearance.alpha.begin() + static_cast<std::ptrdiff_t>(places.size()));
        };
        const std::vector<float> all = alphas(0.0F);
        const std::vector<float> faded = alphas(2.0F);
        // x x (3 - 2 x) of the share of two metres above the floor at 0.5 m: of 0, 1/4, 1/2, 3/4 and 1.
        const std::array<float, 8> shares{0.0F, 0.0F, 0.0F, 0.15625F, 0.5F, 0.84375F, 1.0F, 1.0F};
        for (std::size_t i = 0; i < shares.size(); ++i) {
            QVERIFY(all[i] > 0.0F);
            QVERIFY(std::abs(faded[i] - shares[i] * all[i]) < 1e-6F);
        }
    }

    void densityHoldsAllOfTheSmoke()
    {
        const Effect effect = lookInSun();
        const Lit lit(cloud(effect, box(12)), effect);
        const double mass = 12.0 * 12.0 * 12.0 * 0.5 * M_PI * 0.01 / 3.0;
        QVERIFY(near(crossSection(lit.grid) / mass, 1.0, 1e-3));
    }

    void particlesLargerThanAllOfTheLightStayFinite()
    {
        Effect effect = lookInSun();
        effect.look.overlap = 4.0F;
        const Frame frame = cloud(effect, box(8));
        const Lit lit(frame, effect);
        for (const float cells : {1e3F, 65536.0F, 106977.0F, 1e9F, 1e30F}) {
            Appearance after = lit.appearance;
            after.largestRadius = cells * lit.grid.shape.cell / 0.6F;
            OverlapWorkspace room;
            inflateSparseParticles(frame, sampled(effect), lit.grid, room, after);
            for (std::size_t i = 0; i < after.count; ++i) {
                QVERIFY2(std::isfinite(after.radius[i]) && std::isfinite(after.alpha[i]),
                    qPrintable(QString::number(static_cast<double>(cells))));
                QVERIFY(after.radius[i] >= lit.appearance.radius[i]);
            }
        }
    }

    void layersOfOnePictureGrowAsEachAlone()
    {
        Effect effect = lookInSun();
        effect.look.overlap = 64.0F;
        OverlapWorkspace shared;
        for (const int edge : {4, 9}) { // pictures with light of their own
            const Frame frame = cloud(effect, box(edge));
            const Lit lit(frame, effect);
            const SampledEffect layer = sampled(effect);
            shared.forget();
            for (const float larger : {1.0F, 1.0F, 6.0F, 1.0F}) {
                Appearance together = lit.appearance;
                together.largestRadius *= larger;
                Appearance alone = together;
                OverlapWorkspace own;
                inflateSparseParticles(frame, layer, lit.grid, own, alone);
                inflateSparseParticles(frame, layer, lit.grid, shared, together);
                QVERIFY(!std::equal(alone.radius.begin(), alone.radius.end(), lit.appearance.radius.begin()));
                QVERIFY(std::equal(alone.radius.begin(), alone.radius.end(), together.radius.begin()));
                QVERIFY(std::equal(alone.alpha.begin(), alone.alpha.end(), together.alpha.begin()));
            }
        }
    }

    void thinParticlesLeaveAsMuchSmokeAsDenseOnes()
    {
        // A hundredth of the size and of the alpha that the look allows at most.
        Effect effect = lookInSun();
        effect.life.sizeCurve = Curve{{0.0F, 0.1F}, {1.0F, 1.0F}};
        effect.look.opacity = 0.05F;
        const double mass = 24.0 * 24.0 * 24.0 * 0.005 * M_PI * 0.0001 / 3.0;
        QVERIFY(near(crossSection(Lit(cloud(effect, box(24)), effect).grid) / mass, 1.0, 1e-3));
    }

    void aHeavyParticleTakesNothingFromLightOnes()
    {
        // One newborn of the full alpha, and others of a hundred-thousandth of it, a fraction of a unit each.
        Effect effect = lookInSun();
        effect.life.alphaCurve = Curve{{0.0F, 1.0F}, {0.1F, 0.00002F}, {1.0F, 0.00002F}};
        Frame frame = cloud(effect, box(32));
        age(frame, 0.5F);
        const Lit lit(frame, effect);
        double mass = 0.0;
        for (std::size_t i = 0; i < frame.particles.capacity; ++i) {
            mass += static_cast<double>(lit.appearance.alpha[i]) * M_PI * 0.01 / 3.0;
        }
        const double heavy = 0.5 * M_PI * 0.01 / 3.0;
        const double light = (crossSection(lit.grid) - heavy) / (mass - heavy);
        QVERIFY(near(light, 1.0, 0.02));
    }

    void smokeIsAsBrightInFewParticlesAsInMany()
    {
        Effect effect;
        effect.emitter.count = 64000;
        effect.look.opacity *= 0.25F;
        effect.light.shadow = 6.0F;
        effect.output.width = 64;
        effect.output.height = 64;
        const double many = lightOfSmoke(effect);
        for (const int share : {2, 8, 16}) {
            Effect fewer = effect;
            fewer.emitter.count = effect.emitter.count / share;
            fewer.look.opacity = effect.look.opacity * static_cast<float>(share);
            QVERIFY(near(lightOfSmoke(fewer) / many, 1.0, 0.02));
        }
    }

    void aFewParticlesHaveAFewCells()
    {
        Effect effect = lookInSun();
        effect.look.opacity = 0.05F;
        const Lit lit(cloud(effect, box(10)), effect);
        const GridShape& shape = lit.grid.shape;
        const int inside = (shape.nu - 2) * (shape.nv - 2) * (shape.nw - 2);
        QVERIFY2(inside > 4 * 1000 && inside <= 20 * 1000, qPrintable(QString::number(inside)));
    }

    void denseParticlesHaveLargeCells()
    {
        // In its own cell a particle has an optical depth of alpha pi r^2 / (3 cell^2).
        Effect effect = lookInSun();
        effect.light.shadow = 5.0F;
        const Lit lit(cloud(effect, box(10)), effect);
        const double cell = static_cast<double>(lit.grid.shape.cell);
        QVERIFY(5.0 * 0.5 * M_PI * 0.01 / (3.0 * cell * cell) < 1.0);
    }

    void smokeThatNothingShadowsNeedsNoGrid()
    {
        Effect effect = lookInSun();
        effect.look.overlap = 0.0F;
        const Frame frame = cloud(effect, box(10));
        const auto cells = [&] { return Lit(frame, effect).grid.shape.cells(); };
        effect.light.shadow = 0.0F;
        QVERIFY(cells() > 1000);
        effect.light.ambient = 0.0F;
        QCOMPARE(cells(), std::size_t(1));
        effect.light.ambient = 1.0F;
        effect.light.occlusion = 0.0F;
        QCOMPARE(cells(), std::size_t(1));
        effect.look.overlap = 4.0F;
        QVERIFY(cells() > 1000);
        effect.look.overlap = 0.0F;
        effect.light.anisotropy = 0.5F;
        QVERIFY(cells() > 1 && cells() <= 16 * 16 * 16);
    }

    void smokeWithoutAGridLooksAsWithOne()
    {
        Effect effect;
        effect.emitter.count = 2000;
        effect.output.width = 64;
        effect.output.height = 64;
        effect.light.occlusion = 0.0F;
        for (const float anisotropy : {0.0F, 0.6F}) {
            effect.light.anisotropy = anisotropy;
            effect.light.shadow = 1e-6F;
            const Image with = render(effect, 30);
            effect.light.shadow = 0.0F;
            const Image without = render(effect, 30);
            for (std::size_t i = 0; i < with.pixels.size(); ++i) {
                QVERIFY(std::abs(with.pixels[i] - without.pixels[i]) < 1e-3F);
            }
        }
    }

    void lightFallsOffExponentiallyThroughABox()
    {
        // A box of even extinction: behind a depth s of it, light is exp(-sigma s).
        Effect effect = lookInSun();
        effect.light.resolution = 24;
        const Lit lit(cloud(effect, box(24)), effect);
        const GridShape& shape = lit.grid.shape;
        const std::size_t nu = static_cast<std::size_t>(shape.nu);
        const std::size_t plane = nu * static_cast<std::size_t>(shape.nv);
        const std::size_t middle = static_cast<std::size_t>(shape.nv / 2) * nu + nu / 2;
        const double sigma = 24.0 * 24.0 * 24.0 * 0.5 * M_PI * 0.01 / 3.0;
        for (int w = 4; w < shape.nw - 3; ++w) {
            const double depth =
                static_cast<double>(shape.origin.z + static_cast<float>(w) * shape.cell - lit.appearance.low.z);
            const double tau =
                static_cast<double>(lit.grid.light[(static_cast<std::size_t>(w) * plane + middle) * 4 + 3]);
            const double light =
                static_cast<double>(lit.grid.light[(static_cast<std::size_t>(w) * plane + middle) * 4]);
            QVERIFY(std::abs(light - std::exp(-tau)) < 1e-5);
            QVERIFY2(std::abs(tau - sigma * depth) < 0.08 * sigma,
                qPrintable(QString("tau %1 expected %2").arg(tau).arg(sigma * depth)));
        }
    }

    void oneThinPuffKeepsItsLight()
    {
        Effect effect = lookInSun();
        effect.look.opacity = 0.01F;
        const Lit lit(cloud(effect, {{0.0F, 0.0F, 0.0F}, {5.0F, 5.0F, 5.0F}}), effect);
        for (std::size_t i = 0; i < lit.grid.shape.cells(); ++i) {
            QVERIFY(lit.grid.light[i * 4] > 0.99F && lit.grid.light[i * 4] < 1.001F);
            QVERIFY(std::abs(lit.grid.light[i * 4 + 1] + lit.grid.light[i * 4 + 2] - 2.0F)
                < 0.02F); // sky and ground, each 1 where nothing is in the way
        }
    }

    void phaseFunctionBrightensTowardsTheSun()
    {
        Effect effect = lookInSun();
        effect.look.opacity = 0.01F;
        effect.light.anisotropy = 0.6F;
        const Frame frame = cloud(effect, {{0.0F, 0.0F, 0.0F}, {0.1F, 0.1F, 0.1F}});
        // Light travels down: an eye below looks into the sun.
        const float into = Lit(frame, effect, {0.0F, -50.0F, 0.0F}).grid.light[0];
        const float with = Lit(frame, effect, {0.0F, 50.0F, 0.0F}).grid.light[0];
        QVERIFY(std::abs(into - (1.0F - 0.36F) / std::pow(0.4F, 3.0F)) < 0.1F); // (1 - g^2) / (1 - g)^3
        QVERIFY(std::abs(with - (1.0F - 0.36F) / std::pow(1.6F, 3.0F)) < 0.01F);
    }

    void scatteringReachesDeepButDoesNotBrightenThinSmoke()
    {
        Effect effect = lookInSun();
        const Frame frame = cloud(effect, box(20));
        const auto deepest = [&](float scattering) {
            effect.light.scattering = scattering;
            const Lit lit(frame, effect);
            float least = 1e9F;
            for (std::size_t i = 0; i < lit.grid.shape.cells(); ++i) {
                least = std::min(least, lit.grid.light[i * 4]);
            }
            return least;
        };
        QVERIFY(deepest(0.8F) > 20.0F * deepest(0.0F));
        effect.light.scattering = 0.8F;
        effect.look.opacity = 0.001F;
        QVERIFY(std::abs(Lit(cloud(effect, {{0.0F, 0.0F, 0.0F}, {1.0F, 1.0F, 1.0F}}), effect).grid.light[0] - 1.0F)
            < 1e-3F);
    }

    void emptyFrameIsLitWithoutTrouble()
    {
        const Effect effect = lookInSun();
        Frame frame = cloud(effect, {{0.0F, 0.0F, 0.0F}});
        frame.particles.birthStep[0] = Particles::kUnborn;
        const Lit lit(frame, effect);
        QCOMPARE(lit.appearance.count, std::size_t(0));
    }

    void blackBodyHasTheChromaticityOfIlluminantA()
    {
        // CIE: illuminant A is a black body at 2856 K, x = 0.4476, y = 0.4074.
        const glm::vec3 c = BlackBody(2856.0F).at(2856.0F);
        const double x = 0.4124564 * c.r + 0.3575761 * c.g + 0.1804375 * c.b;
        const double y = 0.2126729 * c.r + 0.7151522 * c.g + 0.0721750 * c.b;
        const double z = 0.0193339 * c.r + 0.1191920 * c.g + 0.9503041 * c.b;
        QVERIFY2(std::abs(x / (x + y + z) - 0.4476) < 0.005 && std::abs(y / (x + y + z) - 0.4074) < 0.005,
            qPrintable(QString("%1 %2").arg(x / (x + y + z)).arg(y / (x + y + z))));
    }

    void blackBodyDimsAndReddensAsItCools()
    {
        const BlackBody body(2000.0F);
        QCOMPARE(body.at(2000.0F).r, 1.0F);
        glm::vec3 hotter = body.at(2000.0F);
        for (float kelvin = 1900.0F; kelvin >= 700.0F; kelvin -= 100.0F) {
            const glm::vec3 colour = body.at(kelvin);
            QVERIFY(colour.r > 0.0F && colour.r < hotter.r);
            QVERIFY(colour.g * hotter.r <= hotter.g * colour.r);
            hotter = colour;
        }
        QCOMPARE(body.at(299.0F), glm::vec3(0.0F));
    }
};

QTEST_GUILESS_MAIN(LightingTest)
#include "lighting_test.moc"
