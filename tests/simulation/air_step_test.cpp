// The steps of the air: how they are divided, and that what they make of an effect depends on no frame rate.
#include "tests/helpers.h"

#include "core/flow/source_kernel.h"
#include "core/preset/library.h"
#include "core/simulation/air_plan.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr std::array kRates{6, 8, 10, 12, 15, 24, 30, 60, 120};

Effect presetOf(const std::string& name)
{
    Effect effect = loadPreset(name).value().preset.scene.effect();
    effect.timeline.timeScale = 1.0F; // a step is one of the frame rate's
    return effect;
}

/// All parts of a step, one after another.
std::vector<AirStep> partsOf(const AirStep& step)
{
    std::vector<AirStep> parts = step.earlier;
    parts.push_back(step);
    return parts;
}

/// With little to compute: another flow, but the same for all frame rates.
Effect small(Effect effect, int cells, int particles)
{
    effect.air.resolution = cells;
    effect.emitter.count = particles;
    effect.timeline.loop = false;
    return effect;
}

/// Moments of the living particles some time after frame 0.
struct Cloud {
    double height = 0.0; ///< m
    double heat = 0.0;
};

Cloud cloudAt(Effect effect, int frameRate, double seconds)
{
    effect.timeline.frameRate = frameRate;
    const auto frame = frameOf(effect, static_cast<int>(std::lround(seconds * frameRate)));
    Cloud sum;
    double count = 0.0;
    for (std::size_t i = 0; i < frame->particles.capacity; ++i) {
        if (lifecycle(*frame, i).alive) {
            sum.height += static_cast<double>(frame->particles.y[i] - effect.emitter.position.y);
            sum.heat += static_cast<double>(frame->particles.heat[i]);
            count += 1.0;
        }
    }
    return {sum.height / count, sum.heat / count};
}

/// Mean of seeds, so that chance does not decide.
Cloud meanCloud(Effect effect, int frameRate, double seconds)
{
    constexpr int kSeeds = 8;
    Cloud mean;
    for (int seed = 1; seed <= kSeeds; ++seed) {
        effect.emitter.seed = static_cast<std::uint32_t>(seed);
        const Cloud cloud = cloudAt(effect, frameRate, seconds);
        mean.height += cloud.height / kSeeds;
        mean.heat += cloud.heat / kSeeds;
    }
    return mean;
}

AirStep airStepOf(const Effect& effect, int number)
{
    return airStep(SimulationModel(sampled(effect)), airGrid(sampled(effect)), number, 1.0F);
}

/// A burst into air that nothing else moves.
Effect spray(float spread)
{
    Effect effect = thesisEffect(20000);
    effect.emitter.shape = EmitterShape::Sphere;
    effect.emitter.radius = 0.4F;
    effect.emitter.speed = 5.0F;
    effect.emitter.spread = spread;
    effect.emitter.normal = {0.0F, 1.0F, 0.0F};
    effect.emitter.position = {0.0F, 1.0F, 0.0F};
    effect.emitter.mode = EmissionMode::Burst;
    effect.emitter.burstDuration = 0.2F;
    effect.timeline.prewarm = false;
    effect.air.enabled = true;
    effect.air.resolution = 32;
    effect.air.turbulence = 0.0F;
    return effect;
}

} // namespace

class AirStepTest : public QObject {
    Q_OBJECT

private slots:
    void noPieceIsLongerThanAirCanBeFollowed_data()
    {
        QTest::addColumn<int>("frameRate");
        for (const int rate : {1, 2, 5, 6, 8, 10, 12, 15, 23, 24, 25, 30, 60, 120, 240}) {
            QTest::newRow(qPrintable(QString::number(rate))) << rate;
        }
    }

    void noPieceIsLongerThanAirCanBeFollowed()
    {
        QFETCH(int, frameRate);
        for (const float expansion : {0.0F, 3.0F, 60.0F, 200.0F, 1000.0F}) {
            Effect effect = small(presetOf("explosion"), 24, 100);
            effect.source.expansion = expansion;
            effect.timeline.frameRate = frameRate;
            const SimulationModel model(sampled(effect));
            const AirGrid grid = airGrid(sampled(effect));
            for (const float acts : {0.0F, 0.3F, 1.0F}) {
                double seconds = 0.0;
                double acting = 0.0;
                float shares = 0.0F;
                for (const AirStep& part : partsOf(airStep(model, grid, 3, acts))) {
                    QVERIFY(part.dt <= 1.0F / 24.0F + 1e-5F);
                    QVERIFY(!part.source.acts || part.dt * expansion <= 0.6F + 1e-3F);
                    seconds += static_cast<double>(part.dt) * part.pieces;
                    acting += part.source.acts ? static_cast<double>(part.dt) * part.pieces : 0.0;
                    shares += part.share;
                }
                QVERIFY(near(seconds * frameRate, 1.0, 1e-5));
                QVERIFY(near(acting * frameRate, static_cast<double>(acts), 1e-5));
                QVERIFY(near(static_cast<double>(shares), 1.0, 1e-5));
            }
        }
    }

    /// From 24 frames a second on a step without a strong expansion is one piece, as it always was.
    void shortStepsAreWhole()
    {
        for (const LibraryEntry& entry : builtinPresets()) {
            Effect effect = presetOf(entry.id);
            if (!effect.air.enabled || effect.source.expansion > 17.0F) {
                continue;
            }
            for (const int rate : {24, 25, 30, 60}) {
                effect.timeline.frameRate = std::max(rate, static_cast<int>(std::ceil(effect.source.expansion / 0.6F)));
                const SimulationModel model(sampled(effect));
                const AirStep step = airStep(model, airGrid(sampled(effect)), 3, 1.0F);
                QVERIFY(
                    step.earlier.empty() && step.pieces == 1 && step.share == 1.0F && step.dt == model.schedule().dt);
            }
        }
    }

    void aBurstActsForItsDurationWhateverAStepIs()
    {
        for (const float duration : {0.04F, 0.15F, 0.35F, 1.0F, 1.5F}) {
            for (const bool loops : {false, true}) {
                for (const int rate : kRates) {
                    Effect effect = presetOf("explosion");
                    effect.emitter.burstDuration = duration;
                    effect.timeline.frameRate = rate;
                    effect.timeline.loop = loops;
                    effect.timeline.length = 4 * rate;
                    const Schedule schedule = makeSchedule(sampled(effect));
                    double acts = 0.0;
                    for (int step = 0; step < 4 * rate; ++step) {
                        acts += static_cast<double>(schedule.actsAfter(step) * schedule.dt);
                    }
                    QVERIFY(near(acts / static_cast<double>(duration), 1.0, 1e-3));
                }
            }
        }
    }

    void lowFrameRatesDoNotLiftSmoke_data()
    {
        QTest::addColumn<QString>("preset");
        for (const char* name : {"default", "campfire", "chimney", "mushroom-cloud"}) {
            QTest::newRow(name) << name;
        }
    }

    void lowFrameRatesDoNotLiftSmoke()
    {
        QFETCH(QString, preset);
        Effect effect = small(presetOf(preset.toStdString()), 24, 1000);
        effect.timeline.prewarm = false;
        const double usual = meanCloud(effect, 30, 3.0).height;
        for (const int rate : {6, 8, 10, 12, 15}) {
            const double height = meanCloud(effect, rate, 3.0).height;
            qInfo("%d/s: %.3f of %.3f m", rate, height, usual);
            QVERIFY(near(height / usual, 1.0, 0.1));
        }
    }

    void anExplosionIsTheSameAtEveryFrameRate()
    {
        const Effect effect = small(presetOf("explosion"), 32, 1000);
        const double heat = meanCloud(effect, 30, 0.4).heat;
        const double height = meanCloud(effect, 30, 2.0).height;
        for (const int rate : {24, 60, 120}) {
            const Cloud early = meanCloud(effect, rate, 0.4);
            const Cloud late = meanCloud(effect, rate, 2.0);
            qInfo("%d/s: heat %.3f of %.3f, height %.3f of %.3f m", rate, early.heat, heat, late.height, height);
            QVERIFY(near(early.heat / heat, 1.0, 0.1));
            QVERIFY(near(late.height / height, 1.0, 0.1));
        }
    }

    void whatSpraysToAllSidesGoesToAllSides_data()
    {
        QTest::addColumn<float>("duration");
        QTest::newRow("at once") << 0.0F;
        QTest::newRow("for a while") << 0.2F;
    }

    void whatSpraysToAllSidesGoesToAllSides()
    {
        QFETCH(float, duration);
        Effect effect = spray(180.0F);
        effect.emitter.burstDuration = duration;
        const auto frame = frameOf(effect, 3);
        glm::dvec3 sum(0.0);
        double up = 0.0;
        double count = 0.0;
        for (std::size_t i = 0; i < frame->particles.capacity; ++i) {
            if (lifecycle(*frame, i).alive) {
                sum += glm::dvec3(frame->particles.vx[i], frame->particles.vy[i], frame->particles.vz[i]);
                up += frame->particles.vy[i] > 0.0F ? 1.0 : 0.0;
                count += 1.0;
            }
        }
        qInfo("mean %.3f %.3f %.3f m/s, %.3f of them up", sum.x / count, sum.y / count, sum.z / count, up / count);
        QVERIFY(glm::length(sum / count) < 0.03 * 5.0);
        QVERIFY(near(up / count, 0.5, 0.02));
    }

    /// In air that stands still what leaves a cone has no less than no speed along it, and in the mean over the
    /// source's first moments no more than it should.
    void noConeSpraysBackwards()
    {
        for (const float spread : {0.0F, 30.0F, 60.0F, 90.0F, 120.0F, 150.0F}) {
            const Effect effect = spray(spread);
            const glm::vec3 along = sourceVelocity(sampled(effect)->emitter);
            QVERIFY(near(static_cast<double>(along.y),
                5.0 * 0.5 * (1.0 + std::cos(static_cast<double>(spread) * 3.14159265358979 / 180.0)), 1e-4));
            const auto frame = frameOf(effect, 2);
            double sum = 0.0;
            double count = 0.0;
            for (std::size_t i = 0; i < frame->particles.capacity; ++i) {
                if (lifecycle(*frame, i).alive) {
                    sum += static_cast<double>(frame->particles.vy[i]);
                    count += 1.0;
                }
            }
            qInfo("%.0f degrees: %.3f m/s of %.3f", static_cast<double>(spread), sum / count,
                static_cast<double>(along.y));
            QVERIFY(sum / count > -0.05);
            QVERIFY(sum / count < 1.1 * static_cast<double>(along.y) + 0.05);
        }
    }

    void aSourceGivesOffAsMuchHeatWhateverItsSeed_data()
    {
        QTest::addColumn<float>("unevenness");
        QTest::addColumn<int>("shape");
        for (const int shape : {0, 1, 2}) {
            for (const float unevenness : {0.4F, 1.5F}) {
                QTest::newRow(
                    qPrintable(QStringLiteral("%1 of shape %2").arg(static_cast<double>(unevenness)).arg(shape)))
                    << unevenness << shape;
            }
        }
    }

    void aSourceGivesOffAsMuchHeatWhateverItsSeed()
    {
        QFETCH(float, unevenness);
        QFETCH(int, shape);
        Effect effect = small(presetOf("default"), 32, 100);
        effect.emitter.shape = static_cast<EmitterShape>(shape);
        effect.source.unevenness = unevenness;
        effect.source.surge = 0.0F;
        std::vector<double> heats;
        for (std::uint32_t seed = 1; seed <= 24; ++seed) {
            effect.emitter.seed = seed;
            const AirStep step = airStep(SimulationModel(sampled(effect)), airGrid(sampled(effect)), 7, 1.0F);
            heats.push_back(static_cast<double>(step.source.heat * meanUnevenness(step.source)));
        }
        const Moments all = Moments::of(heats);
        qInfo("%.3f, from %.3f to %.3f", all.mean, all.low, all.high);
        QVERIFY(all.high < 1.02 * all.low);
        // The mean of max(0, 1 + s n), n normally distributed, s with the octave that only heat has.
        const double s = static_cast<double>(unevenness) * std::sqrt(1.2);
        const double below = 0.5 * (1.0 + std::erf(1.0 / s / std::sqrt(2.0)));
        QVERIFY(near(all.mean, below + s * std::exp(-0.5 / (s * s)) / std::sqrt(2.0 * 3.14159265358979), 0.01));
    }

    void aSourceThatIsFarAwayIsNowhereInTheBox()
    {
        Effect effect = small(presetOf("default"), 24, 100);
        SimulationModel model(sampled(effect));
        const AirGrid grid = airGrid(sampled(effect));
        for (const float far : {1e4F, 1e9F, 1e20F, 1e38F}) {
            for (const float sign : {-1.0F, 1.0F}) {
                model.placeEmitter(glm::vec3(sign * far), {0.0F, 1.0F, 0.0F});
                const AirSource source = airStep(model, grid, 1, 1.0F).source;
                QVERIFY(glm::all(glm::greaterThanEqual(source.first, glm::ivec3(0)))
                    && glm::all(glm::lessThanEqual(source.first, source.last)));
                QVERIFY(source.last.y <= grid.cells.y && source.last.z <= grid.cells.z);
                QVERIFY(source.first.y == source.last.y && source.first.z == source.last.z);
            }
        }
    }

    void noBuiltInPresetIsBakedForTooLong()
    {
        for (const LibraryEntry& entry : builtinPresets()) {
            Effect effect = loadPreset(entry).value().preset.scene.effect();
            QVERIFY(checkAir(sampled(effect)));
            effect.timeline.loop = true;
            effect.timeline.length = 600;
            QVERIFY(checkAir(sampled(effect)));
        }
    }

    /// Puffs add nothing in the mean, leave no gap between them, and are the same in every turn of a loop.
    void surgesKeepTheMean()
    {
        Effect effect = small(presetOf("default"), 16, 10);
        effect.source.unevenness = 0.0F;
        effect.source.expansion = 2.0F;
        effect.source.surge = 0.0F;
        const float even = airStepOf(effect, 1).source.speed;
        effect.source.surge = 0.9F;
        effect.source.surgeRate = 1.7F;
        double sum = 0.0;
        double squares = 0.0;
        double roughest = 0.0;
        double before = 0.0;
        constexpr int kSteps = 30 * 400;
        for (int step = 1; step <= kSteps; ++step) {
            const AirSource source = airStepOf(effect, step).source;
            const auto heat = static_cast<double>(source.heat);
            QVERIFY(heat > 0.0);
            QVERIFY(near(static_cast<double>(source.speed), heat * static_cast<double>(even), 1e-4));
            QVERIFY(near(static_cast<double>(source.expansion), heat * 2.0, 1e-4));
            roughest = step == 1 ? 0.0 : std::max(roughest, std::abs(heat - before));
            before = heat;
            sum += heat;
            squares += heat * heat;
        }
        const double mean = sum / kSteps;
        QVERIFY(near(mean, 1.0, 0.02));
        QVERIFY(std::sqrt(squares / kSteps - mean * mean) > 0.25);
        QVERIFY(roughest < 0.5); // of a rise within 6 steps
        effect.timeline.loop = true;
        const SimulationModel model(sampled(effect));
        const AirGrid grid = airGrid(sampled(effect));
        for (const int step : {1, 20, 77}) {
            const auto later = step + model.schedule().loopSteps;
            QCOMPARE(airStep(model, grid, step, 1.0F).source.heat, airStep(model, grid, later, 1.0F).source.heat);
        }
    }

    void aBurstHasNoSurge()
    {
        Effect effect = small(presetOf("explosion"), 16, 10);
        const AirSource even = airStepOf(effect, 1).source;
        effect.source.surge = 1.0F;
        QCOMPARE(airStepOf(effect, 1).source.heat, even.heat);
    }

    void anHourBeforeThePictureIsRefusedWithARemedy()
    {
        Effect effect = small(presetOf("default"), 64, 10);
        effect.timeline.loop = true;
        effect.timeline.length = 100000;
        const Status loop = checkAir(sampled(effect));
        QVERIFY(!loop);
        QCOMPARE(loop.error().code, ErrorCode::TooLarge);
        QCOMPARE(loop.error().place.text(), std::string("timeline.length"));
        effect.timeline.loop = false;
        QVERIFY(checkAir(sampled(effect))); // whoever asks for frame 90 000 is told how far it is
        effect.timeline.prewarm = true;
        effect.timeline.frameRate = 240;
        effect.timeline.stepsPerFrame = 32;
        effect.life.initialAlpha = 1.0F;
        effect.life.fadeRate = 0.001F;
        const Status warm = checkAir(sampled(effect));
        QVERIFY(!warm);
        QCOMPARE(warm.error().place.text(), std::string("timeline.prewarm"));
        effect.timeline.prewarm = false;
        QVERIFY(checkAir(sampled(effect)));
    }
};

QTEST_GUILESS_MAIN(AirStepTest)
#include "air_step_test.moc"
