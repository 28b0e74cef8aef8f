// Light of what glows on the smoke around it, against the inverse square of the distance.

#include "tests/helpers.h"
#include "tests/lighting/clouds.h"

#include "core/lighting/appearance.h"
#include "core/lighting/fire_light.h"

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr float kEdge = 4.0F; // of the cube of smoke, m
constexpr int kAlongEdge = 16;
constexpr float kBetween = kEdge / (kAlongEdge - 1); // particles, m

/// Evenly spread smoke, of which only the first particle, in the middle, is young enough to glow.
Effect lookOfFire()
{
    Effect effect = evenLook();
    effect.life.fadeRate = 0.05F;
    effect.life.initialAlpha = 0.1F;
    effect.light.shadow = 0.0F;
    effect.light.occlusion = 0.7F;
    effect.glow.emission = 3.0F;
    effect.glow.emissionCooling = 100.0F;
    effect.glow.emissionColour = EmissionColour::Gradient;
    effect.glow.emissionGradient = Gradient{{0.0F, glm::vec3(0.0F)}, {1.0F, glm::vec3(1.0F, 0.5F, 0.25F)}};
    return effect;
}

struct LitByFire {
    Frame frame;
    Appearance appearance;
    LightGrid grid;
    LightWorkspace room;
    FireWorkspace fire;

    explicit LitByFire(const Effect& effect)
    {
        std::vector<glm::vec3> places{glm::vec3(0.5F * kEdge)};
        for (int i = 0; i < kAlongEdge * kAlongEdge * kAlongEdge; ++i) {
            const glm::vec3 cell(i % kAlongEdge, i / kAlongEdge % kAlongEdge, i / (kAlongEdge * kAlongEdge));
            places.push_back(cell * kBetween);
        }
        frame = cloud(effect, places);
        age(frame, 0.5F);
        findAppearance(frame, sampled(effect), lightAxes(effect.light.direction), appearance);
        const LitLayer layer{&frame, &effect, &appearance, nullptr};
        lightSmoke({&layer, 1}, {0.0F, 0.0F, 20.0F}, room, grid);
        lightByFire({&layer, 1}, fire, room, grid);
    }

    /// Light at the cell nearest to a place, and how far its centre is from the middle.
    [[nodiscard]] std::pair<double, double> at(const glm::vec3& place) const
    {
        const Axes& axes = grid.shape.axes;
        const auto along = [&](const glm::vec3& p) {
            return glm::vec3(glm::dot(p, axes.u), glm::dot(p, axes.v), glm::dot(p, axes.w));
        };
        const glm::ivec3 cell(glm::round((along(place) - grid.shape.origin) / grid.shape.cell));
        const glm::vec3 centre = grid.shape.origin + glm::vec3(cell) * grid.shape.cell;
        const auto i = static_cast<std::size_t>((cell.z * grid.shape.nv + cell.y) * grid.shape.nu + cell.x);
        return {grid.fire[i], glm::distance(centre, along(glm::vec3(0.5F * kEdge)))};
    }
};

} // namespace

class FireLightTest : public QObject {
    Q_OBJECT

private slots:
    void lightFallsWithTheSquareOfTheDistance()
    {
        const Effect effect = lookOfFire();
        const LitByFire lit(effect);
        // Radiance times opacity times the area of the soft disc.
        constexpr double kPower = 3.0 * (0.2126 + 0.5 * 0.7152 + 0.25 * 0.0722) * 0.5 * 3.14159265 * 0.1 * 0.1 / 3.0;
        double product = 1.0;
        int count = 0;
        for (const glm::vec3 way : {glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, -1),
                 glm::vec3(1, 1, 0), glm::vec3(1, -1, 1), glm::vec3(0.3, 0.8, -0.5)}) {
            for (const float distance : {0.8F, 1.1F, 1.5F, 1.8F}) {
                const auto [light, metres] = lit.at(glm::vec3(0.5F * kEdge) + glm::normalize(way) * distance);
                const double expected = kPower / (4.0 * 3.14159265 * metres * metres);
                QVERIFY2(light > 0.7 * expected && light < 1.3 * expected,
                    qPrintable(QStringLiteral("%1 of %2 at %3 m").arg(light).arg(expected).arg(metres)));
                product *= light / expected;
                ++count;
            }
        }
        QVERIFY(near(std::pow(product, 1.0 / count), 1.0, 0.1)); // no bias
        QVERIFY(near(lit.grid.fireColour.g / lit.grid.fireColour.r, 0.5, 1e-3));
        QVERIFY(near(lit.grid.fireColour.b / lit.grid.fireColour.r, 0.25, 1e-3));
    }

    void smokeBetweenTakesLight()
    {
        Effect effect = lookOfFire();
        const LitByFire clear(effect);
        effect.light.shadow = 1.0F;
        const LitByFire dense(effect);
        // Extinction of discs of half that alpha, one to each cube between them; beyond the last of them there is none,
        // which coarse levels see.
        constexpr double kExtinction = 0.25 * 3.14159265 * 0.01 / 3.0 / (kBetween * kBetween * kBetween);
        for (const float distance : {0.5F, 0.8F}) {
            const auto [light, metres] = dense.at(glm::vec3(0.5F * kEdge + distance, 0.5F * kEdge, 0.5F * kEdge));
            const double through =
                light / clear.at(glm::vec3(0.5F * kEdge + distance, 0.5F * kEdge, 0.5F * kEdge)).first;
            QVERIFY(near(std::log(through) / (-kExtinction * metres), 1.0, 0.4));
        }
    }

    void clearFlamesGiveAsMuchLightAsOpaqueOnes()
    {
        Effect effect = lookOfFire();
        const LitByFire opaque(effect);
        effect.glow.flameOpacity = 0.1F;
        const LitByFire clear(effect);
        const glm::vec3 place(0.5F * kEdge + 1.0F, 0.5F * kEdge, 0.5F * kEdge);
        QVERIFY(near(clear.at(place).first / opaque.at(place).first, 1.0, 0.01));
    }

    void nothingIsLitWhereNothingGlowsOrNoneIsAskedFor()
    {
        Effect effect = lookOfFire();
        effect.glow.fireLight = 0.0F;
        QVERIFY(LitByFire(effect).grid.fire.empty());
        effect.glow.fireLight = 1.0F;
        effect.glow.emission = 0.0F;
        QVERIFY(LitByFire(effect).grid.fire.empty());
        effect.glow.emission = 1.0F;
        effect.glow.emissionGradient = Gradient{{0.0F, glm::vec3(0.0F)}, {1.0F, glm::vec3(0.0F)}};
        QVERIFY(LitByFire(effect).grid.fire.empty());
    }

    void theSameBitsOnEveryInstructionSet()
    {
        const SimdGuard guard;
        const LitByFire best(lookOfFire());
        for (const std::string& target : availableSimdTargets()) {
            QVERIFY(forceSimdTarget(target).ok());
            const LitByFire other(lookOfFire());
            QVERIFY2(sameBits(best.grid.fire, other.grid.fire), target.c_str());
        }
    }

    void pictureIsBrighterAndTemperatureIsNot()
    {
        Effect effect = everythingOn();
        effect.glow.fireLight = 0.0F;
        const Image without = render(effect, 30);
        effect.glow.fireLight = 1.0F;
        const Image with = render(effect, 30);
        double more = 0.0;
        for (std::size_t i = 0; i < with.pixels.size(); ++i) {
            QVERIFY(with.pixels[i] >= without.pixels[i] - 1e-5F);
            more += static_cast<double>(with.pixels[i] - without.pixels[i]);
        }
        QVERIFY(more > 0.0);
    }
};

QTEST_APPLESS_MAIN(FireLightTest)
#include "fire_light_test.moc"
