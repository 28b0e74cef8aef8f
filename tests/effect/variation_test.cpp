#include "tests/helpers.h"

#include "core/effect/known_parameter.h"
#include "core/effect/parameter_table.h"
#include "core/effect/value.h"
#include "core/effect/variation.h"

#include <cmath>

using namespace fumage;

class VariationTest : public QObject {
    Q_OBJECT

private slots:
    void theSameSeedGivesTheSameNeighbour()
    {
        QVERIFY(vary(Effect(), 0.1F, 7) == vary(Effect(), 0.1F, 7));
        QVERIFY(!(vary(Effect(), 0.1F, 7) == vary(Effect(), 0.1F, 8)));
    }

    void anAmountOfNothingChangesNothing() { QVERIFY(vary(Effect(), 0.0F, 7) == Effect()); }

    void onlyTheCharacterMoves()
    {
        const Effect other = vary(Effect(), 0.2F, 7);
        for (const Parameter* parameter : differences(Effect(), other)) {
            QVERIFY2(isCharacter(*parameter), std::string(parameter->key).c_str());
        }
        QCOMPARE(other.emitter.count, Effect().emitter.count);
        QVERIFY(other.camera == Effect().camera);
        QVERIFY(other.timeline == Effect().timeline);
        QVERIFY(other.output == Effect().output);
        QCOMPARE(other.emitter.seed, Effect().emitter.seed);
    }

    void whatIsLockedStays()
    {
        const auto mayVary = [](const Parameter& parameter) {
            return isCharacter(parameter) && parameter.group() != "light";
        };
        QVERIFY(vary(Effect(), 0.3F, 7, mayVary).light == Effect().light);
    }

    void whatIsOffStaysOff()
    {
        const Effect other = vary(Effect(), 0.3F, 7);
        QCOMPARE(other.vortex.strength, 0.0F);
        QCOMPARE(other.motion.gravity, 0.0F);
        QCOMPARE(other.glow.emission, 0.0F);
    }

    void everyValueIsInRange()
    {
        for (std::uint32_t seed = 0; seed < 200; ++seed) {
            const Effect other = vary(Effect(), 1.0F, seed);
            for (const Parameter& parameter : parameterTable()) {
                QVERIFY2(!clampValue(parameter, parameter.get(other)).changed, std::string(parameter.key).c_str());
            }
        }
    }

    void aParameterMovesByItsShareOfTheSoftRange()
    {
        // Drag goes from 0 to 5 with 0.8 in the middle of neither end: mean and deviation over many seeds.
        const Parameter& drag = knownParameter("motion.drag");
        const auto mayVary = [&](const Parameter& parameter) { return parameter.key == drag.key; };
        constexpr int kTrials = 4000;
        double sum = 0.0;
        double squares = 0.0;
        for (std::uint32_t seed = 0; seed < kTrials; ++seed) {
            const double way =
                static_cast<double>(vary(Effect(), 0.02F, seed, mayVary).motion.drag - Effect().motion.drag);
            sum += way;
            squares += way * way;
        }
        const double span = std::min(5.0, 4.0 * 0.8 + 0.5);
        const double deviation = std::sqrt(squares / kTrials);
        QVERIFY(std::abs(sum / kTrials) < 4.0 * 0.02 * span / std::sqrt(kTrials)); // four standard errors
        QVERIFY(std::abs(deviation / (0.02 * span) - 1.0) < 0.05);
    }
};

QTEST_APPLESS_MAIN(VariationTest)
#include "variation_test.moc"
