#include "tests/helpers.h"

#include "core/effect/known_parameter.h"
#include "core/effect/parameter_table.h"
#include "core/effect/assignment.h"
#include "core/effect/value.h"

#include <set>

using namespace fumage;

class EffectTest : public QObject {
    Q_OBJECT

private slots:
    void keysAreUniqueAndRowsComplete()
    {
        std::set<std::string_view> keys;
        for (const Parameter& p : parameterTable()) {
            QVERIFY2(keys.insert(p.key).second, p.key.data());
            QVERIFY(!p.label.empty() && !p.synonyms.empty() && !p.tip.empty() && p.get != nullptr && p.set != nullptr);
            QVERIFY(!groupLabel(p.group()).empty());
            if (p.kind == Kind::Choice) {
                QVERIFY(p.choices.size() >= 2);
            } else if (p.kind != Kind::Bool && p.kind != Kind::Picture) {
                QVERIFY2(
                    p.hard.low < p.hard.high && p.hard.low <= p.soft.low && p.soft.high <= p.hard.high && p.step > 0.0,
                    p.key.data());
            }
            QVERIFY2(p.scale == Scale::Linear || p.soft.low > 0.0, p.key.data());
            QVERIFY(p.visible.key.empty() || findParameter(p.visible.key) != nullptr);
        }
    }

    void defaultsAreInRange()
    {
        const Effect defaults;
        for (const Parameter& p : parameterTable()) {
            if (p.kind == Kind::Direction) {
                continue; // documents hold unit vectors; the default is one once it is clamped
            }
            QVERIFY2(!clampValue(p, p.get(defaults)).changed, p.key.data());
        }
    }

    void textRoundTripsForEveryParameter()
    {
        const Effect effect = tests::everythingOn();
        for (const Parameter& p : parameterTable()) {
            const Value value = clampValue(p, p.get(effect)).value;
            const Result<Clamped> parsed = parseValue(p, formatText(p, value));
            QVERIFY2(parsed.ok(), p.key.data());
            QVERIFY2(parsed.value().value == value && !parsed.value().changed, p.key.data());
        }
    }

    void clampsAtBothEnds()
    {
        for (const Parameter& p : parameterTable()) {
            Effect effect;
            if (p.kind == Kind::Float) {
                QVERIFY(setClamped(effect, p, Value(3e38F)));
                QCOMPARE(std::get<float>(p.get(effect)), static_cast<float>(p.hard.high));
                QVERIFY(setClamped(effect, p, Value(-3e38F)));
                QCOMPARE(std::get<float>(p.get(effect)), static_cast<float>(p.hard.low));
            } else if (p.kind == Kind::Int) {
                QVERIFY(setClamped(effect, p, Value(2147483647)));
                QCOMPARE(std::get<int>(p.get(effect)), static_cast<int>(p.hard.high));
                QVERIFY(setClamped(effect, p, Value(-2147483647)));
                QCOMPARE(std::get<int>(p.get(effect)), static_cast<int>(p.hard.low));
            }
        }
    }

    void nanAndInfinityAreRefused()
    {
        for (const Parameter& p : parameterTable()) {
            for (const std::string text : {"nan", "inf", "-inf", "1e999"}) {
                QVERIFY2(!parseValue(p, text), p.key.data());
                QVERIFY2(!parseValue(p, text + ",0,0"), p.key.data());
            }
        }
    }

    void seedsOutOfRangeAreClampedAndSaid()
    {
        Effect effect;
        for (const auto& [text, seed] : {std::pair{"-5", 0U}, std::pair{"1e11", 4294967295U},
                 std::pair{"100000000000", 4294967295U}, std::pair{"99999999999999999999999", 4294967295U}}) {
            const Result<bool> clamped = applyAssignment(effect, std::string("emitter.seed=") + text);
            QVERIFY2(clamped.ok() && clamped.value(), text);
            QCOMPARE(effect.emitter.seed, seed);
        }
        QVERIFY(!applyAssignment(effect, "emitter.seed=4294967295").value());
        QVERIFY(!applyAssignment(effect, "emitter.seed=010").value());
        QCOMPARE(effect.emitter.seed, 10U);
    }

    void wrongShapesAreRefused()
    {
        for (const Parameter& p : parameterTable()) {
            for (const char* text : {"", "rubbish", "1,2", "[[1],[2,3]]", "1;2"}) {
                const bool isNone = p.kind == Kind::Picture && *text == '\0';
                QVERIFY2(parseValue(p, text).ok() == isNone, p.key.data());
            }
        }
    }

    void directionsBecomeUnitVectors()
    {
        const Parameter& p = knownParameter("emitter.normal");
        Effect effect;
        setClamped(effect, p, Value(glm::vec3(3.0F, 0.0F, 4.0F)));
        QCOMPARE(effect.emitter.normal, glm::vec3(0.6F, 0.0F, 0.8F));
        setClamped(effect, p, Value(glm::vec3(0.0F)));
        QCOMPARE(effect.emitter.normal, glm::vec3(0.0F, 1.0F, 0.0F));
        // A unit vector that is clamped again keeps its bits, or saving would not be canonical.
        const glm::vec3 once = effect.emitter.normal;
        setClamped(effect, p, Value(once));
        QCOMPARE(effect.emitter.normal, once);
    }

    void aDirectionOfAnyLengthIsAllowedAndNoneIsNot()
    {
        for (const Parameter& p : parameterTable()) {
            if (p.kind != Kind::Direction) {
                continue;
            }
            Effect effect;
            const std::string key(p.key);
            for (const char* text : {"0.3,0.2,-0.1", "1,1,1", "0,-0.001,0", "[-1, 1, 0.5]"}) {
                const Result<bool> clamped = applyAssignment(effect, key + "=" + text);
                QVERIFY2(clamped.ok() && !clamped.value(), (key + "=" + text).c_str());
                const auto direction = std::get<glm::vec3>(p.get(effect));
                QVERIFY(std::abs(glm::length(direction) - 1.0F) < 1e-6F);
            }
            QVERIFY2(applyAssignment(effect, key + "=0,0,0").value(), key.c_str());
            QVERIFY2(applyAssignment(effect, key + "=0,7,0").value(), key.c_str()); // more than the table allows
        }
    }

    void assignmentsSayWhatIsWrong()
    {
        Effect effect;
        QVERIFY(applyAssignment(effect, "wind.strength=1.5").ok());
        QCOMPARE(effect.wind.strength, 1.5F);
        QVERIFY(applyAssignment(effect, "emitter.shape=rectangle").ok());
        QCOMPARE(effect.emitter.shape, EmitterShape::Rectangle);
        QVERIFY(applyAssignment(effect, "look.colour=[1, 0.5, 0]").ok());
        QCOMPARE(effect.look.colour, glm::vec3(1.0F, 0.5F, 0.0F));
        QVERIFY(applyAssignment(effect, "life.size=[[0, 0.1], [1, 1]]").ok());
        QCOMPARE(effect.life.sizeCurve.count, 2);
        QCOMPARE(applyAssignment(effect, "motion.wnd=1").error().code, ErrorCode::UnknownKey);
        QVERIFY(applyAssignment(effect, "motion.wnd=1").error().text().find("wind.strength") != std::string::npos);
        QCOMPARE(applyAssignment(effect, "wind.strength").error().code, ErrorCode::Syntax);
        QCOMPARE(applyAssignment(effect, "emitter.shape=cube").error().code, ErrorCode::UnknownName);
        QVERIFY(applyAssignment(effect, "motion.randomness=7").value());
        QCOMPARE(effect.motion.randomness, 1.0F);
    }

    void differencesListWhatWasChanged()
    {
        Effect effect;
        effect.wind.strength = 9.0F;
        effect.look.mask = MaskShape::Square;
        const std::vector<const Parameter*> rows = differences(effect, Effect{});
        QCOMPARE(rows.size(), std::size_t(2));
        QCOMPARE(rows[0]->key, std::string_view("wind.strength"));
        QCOMPARE(rows[1]->key, std::string_view("look.mask"));
    }

    void curvesPassThroughTheirPointsAndStayBetween()
    {
        const Curve curve{{0.0F, 0.2F}, {0.3F, 0.9F}, {0.35F, 0.1F}, {1.0F, 0.8F}};
        for (const CurvePoint& point : curve.points()) {
            QVERIFY(std::abs(curve.at(point.x) - point.y) < 1e-6F);
        }
        for (float x = -0.5F; x < 1.5F; x += 0.001F) {
            QVERIFY(curve.at(x) >= 0.1F - 1e-5F && curve.at(x) <= 0.9F + 1e-5F);
        }
        QCOMPARE((Curve{{0.5F, 0.7F}}).at(0.1F), 0.7F);
    }

    void gradientsAreLinearBetweenStops()
    {
        const Gradient gradient{{0.0F, {0.0F, 0.0F, 0.0F}}, {0.5F, {1.0F, 0.5F, 0.0F}}};
        QCOMPARE(gradient.at(0.25F), glm::vec3(0.5F, 0.25F, 0.0F));
        QCOMPARE(gradient.at(0.9F), glm::vec3(1.0F, 0.5F, 0.0F));
    }

    void hiddenParametersFollowTheirChoice()
    {
        Effect effect;
        effect.emitter.shape = EmitterShape::Disc;
        QVERIFY(!isVisible(knownParameter("emitter.width"), effect));
        effect.emitter.shape = EmitterShape::Rectangle;
        QVERIFY(isVisible(knownParameter("emitter.width"), effect));
    }
};

QTEST_GUILESS_MAIN(EffectTest)
#include "effect_test.moc"
