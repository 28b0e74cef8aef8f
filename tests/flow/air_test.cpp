#include "tests/flow/air_helpers.h"

#include <glm/geometric.hpp>

#include <QtTest/QtTest>

using namespace fumage;
using namespace fumage::tests;

class AirTest : public QObject {
    Q_OBJECT

private slots:
    void aStepIsTheSameWhateverWasAskedForBefore()
    {
        BakedAir forwards(smallPlan());
        std::map<std::int64_t, AlignedArray<std::uint16_t>> expected;
        for (std::int64_t step = 1; step <= 120; ++step) {
            expected[step] = bitsAt(forwards, step);
        }
        BakedAir jumping(smallPlan());
        for (const std::int64_t step : {77, 3, 120, 119, 60, 61, 1, 100}) {
            QVERIFY(bitsAt(jumping, step) == expected[step]);
        }
    }

    void whatDoesNotFitIntoTheBudgetIsComputedAgain()
    {
        const AirPlan plan = smallPlan();
        BakedAir whole(plan);
        constexpr std::size_t kSmall = 3000000;
        BakedAir small(plan, kSmall);
        for (const std::int64_t step : {150, 20, 149, 21, 22, 140, 1, 150}) {
            QVERIFY(bitsAt(small, step) == bitsAt(whole, step));
            QVERIFY(small.keptBytes() <= kSmall);
        }
        QVERIFY(whole.keptBytes() > kSmall);
    }

    void theBudgetHoldsForALongBakeOfALargeBox()
    {
        // What is kept counts, so that the numbers show it without the minutes that a thousand steps of 64x128x64 take.
        const AirPlan plan = smallPlan(0, {9, 12, 8});
        constexpr std::size_t kBudget = 1000000;
        BakedAir air(plan, kBudget);
        QVERIFY(air.bake(1000).ok());
        QVERIFY(air.keptBytes() <= kBudget);
        QVERIFY(air.isBaked(1000));
        QVERIFY(!air.isBaked(1001));
    }

    void aLoopGoesOverIntoItsBeginning()
    {
        constexpr std::int64_t kLength = 40;
        BakedAir air(smallPlan(kLength));
        QVERIFY(air.bake(0).ok());
        QVERIFY(bitsAt(air, 7) == bitsAt(air, 7 + 3 * kLength));
        // On its way over, and at the seam, it changes no more than elsewhere.
        const auto change = [&](std::int64_t step) {
            double sum = 0.0;
            const auto before = air.field(step).value();
            const auto after = air.field(step + 1).value();
            for (int i = 0; i < 400; ++i) {
                const glm::vec3 place = before->grid.corner
                    + 2.0F
                        * glm::vec3(static_cast<float>(i % 10) / 15.0F, static_cast<float>(i / 10 % 10) / 10.0F,
                            static_cast<float>(i / 100) / 6.0F);
                const glm::vec4 off = after->at(place) - before->at(place);
                sum += static_cast<double>(off.x * off.x + off.y * off.y + off.z * off.z);
            }
            return std::sqrt(sum);
        };
        // From step 20 to 40 of the turn, which begins at step 60, the air is what it is without a loop.
        double most = 0.0;
        for (std::int64_t step = 20; step < kLength; ++step) {
            most = std::max(most, change(step));
        }
        double over = 0.0;
        for (std::int64_t step = 0; step < 20; ++step) {
            over = std::max(over, change(step));
        }
        qInfo("at most %.4f on the way over, %.4f elsewhere", over, most);
        QVERIFY(over < 1.2 * most);
    }

    void aLoopIsTheAirItselfUntilItGoesOver()
    {
        constexpr std::int64_t kLength = 40;
        constexpr std::int64_t kFade = kLength / 2;
        AirPlan endless = smallPlan(kLength);
        endless.loopSteps = 0;
        BakedAir raw(endless);
        BakedAir loop(smallPlan(kLength));
        const std::int64_t start = kLength + kFade; // the first step, and as long as it goes over
        for (std::int64_t step = start; step <= start + kLength - kFade; ++step) {
            QVERIFY(bitsAt(loop, step) == bitsAt(raw, step));
        }
        // A quarter of the way through its end it is three quarters of what it is, and a quarter of what came a turn
        // before.
        const std::int64_t middle = start + kLength - kFade + kFade / 4;
        const glm::vec3 place{0.1F, 0.6F, 0.05F};
        const glm::vec4 expected =
            0.75F * raw.field(middle).value()->at(place) + 0.25F * raw.field(middle - kLength).value()->at(place);
        const glm::vec4 seen = loop.field(middle).value()->at(place);
        QVERIFY(glm::length(seen - expected) < 2e-3F * glm::length(expected)); // half floats
    }

    void aLoopThatDoesNotFitIntoTheBudgetIsTheSame()
    {
        constexpr std::int64_t kLength = 40;
        BakedAir whole(smallPlan(kLength));
        constexpr std::size_t kSmall = 1900000; // a turn takes 2.5 MB
        BakedAir small(smallPlan(kLength), kSmall);
        for (const std::int64_t step : {59, 60, 61, 78, 79, 80, 81, 40, 99, 72, 73}) {
            QVERIFY(bitsAt(small, step) == bitsAt(whole, step));
            QVERIFY(small.keptBytes() <= kSmall);
        }
        QVERIFY(whole.keptBytes() > kSmall);
    }

    void aBakeThatIsCancelledGoesOnLater()
    {
        BakedAir air(smallPlan());
        std::stop_source source;
        const Status stopped = air.bake(100, source.get_token(), [&](double share) {
            if (share > 0.3) {
                source.request_stop();
            }
        });
        QVERIFY(!stopped.ok() && stopped.error().code == ErrorCode::Cancelled);
        QVERIFY(!air.isBaked(40));
        double last = 0.0;
        QVERIFY(air.bake(100, {},
                       [&](double share) {
                           QVERIFY(share >= last);
                           last = share;
                       })
                    .ok());
        QCOMPARE(last, 1.0);
        BakedAir whole(smallPlan());
        QVERIFY(bitsAt(air, 100) == bitsAt(whole, 100));
    }
};

QTEST_APPLESS_MAIN(AirTest)
#include "air_test.moc"
