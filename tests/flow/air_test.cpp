#include "tests/flow/flow_helpers.h"

#include "core/flow/air.h"

#include <thread>

#include <QtTest/QtTest>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// A ragged plume in a small box.
AirPlan smallPlan(std::int64_t loopSteps = 0)
{
    AirPlan plan;
    plan.grid = boxOf({17, 24, 16}, 2.0F);
    plan.borders = onGround();
    plan.firstStep = loopSteps;
    plan.loopSteps = loopSteps;
    plan.stepTo = [grid = plan.grid, loopSteps](std::int64_t number) {
        AirStep step = plumeStep(grid, 0.3F);
        const std::int64_t seen = loopSteps == 0 ? number : number % loopSteps;
        makeRagged(step, 0.3F, static_cast<float>(seen) * step.dt);
        step.confinement = 0.1F;
        return step;
    };
    return plan;
}

AlignedArray<std::uint16_t> bitsAt(Air& air, std::int64_t step)
{
    return air.field(step).value()->quads;
}

} // namespace

class AirTest : public QObject {
    Q_OBJECT

private slots:
    void aStepIsTheSameWhateverWasAskedForBefore()
    {
        Air forwards(smallPlan());
        std::map<std::int64_t, AlignedArray<std::uint16_t>> expected;
        for (std::int64_t step = 1; step <= 120; ++step) {
            expected[step] = bitsAt(forwards, step);
        }
        Air jumping(smallPlan());
        for (const std::int64_t step : {77, 3, 120, 119, 60, 61, 1, 100}) {
            QVERIFY(bitsAt(jumping, step) == expected[step]);
        }
    }

    void whatDoesNotFitIntoTheBudgetIsComputedAgain()
    {
        const AirPlan plan = smallPlan();
        Air whole(plan);
        constexpr std::size_t kSmall = 3000000;
        Air small(plan, kSmall);
        for (const std::int64_t step : {150, 20, 149, 21, 22, 140, 1, 150}) {
            QVERIFY(bitsAt(small, step) == bitsAt(whole, step));
            QVERIFY(small.keptBytes() <= kSmall);
        }
        QVERIFY(whole.keptBytes() > kSmall);
    }

    void theBudgetHoldsForALongBakeOfALargeBox()
    {
        // What is kept counts, so that the numbers show it without the minutes that a thousand steps of 64x128x64 take.
        AirPlan plan = smallPlan();
        constexpr std::size_t kBudget = 8000000;
        Air air(plan, kBudget);
        QVERIFY(air.bake(1000).ok());
        QVERIFY(air.keptBytes() <= kBudget);
        QCOMPARE(air.bakedSteps(), std::int64_t(1000));
    }

    void aLoopGoesOverIntoItsBeginning()
    {
        constexpr std::int64_t kLength = 40;
        Air air(smallPlan(kLength));
        QVERIFY(air.bake(0).ok());
        QVERIFY(bitsAt(air, 7) == bitsAt(air, 7 + 3 * kLength));
        // From its last step to its first it changes no more than elsewhere.
        const auto change = [&](std::int64_t step) {
            double sum = 0.0;
            const auto before = air.field(step).value();
            const auto after = air.field(step + 1).value();
            for (int i = 0; i < 400; ++i) {
                const glm::vec3 place = before->grid.corner + 2.0F * glm::vec3(static_cast<float>(i % 10) / 15.0F, static_cast<float>(i / 10 % 10) / 10.0F, static_cast<float>(i / 100) / 6.0F);
                const glm::vec4 off = after->at(place) - before->at(place);
                sum += static_cast<double>(off.x * off.x + off.y * off.y + off.z * off.z);
            }
            return std::sqrt(sum);
        };
        double most = 0.0;
        for (std::int64_t step = 0; step < kLength - 1; ++step) {
            most = std::max(most, change(step));
        }
        qInfo("%.4f at the seam, at most %.4f elsewhere", change(kLength - 1), most);
        QVERIFY(change(kLength - 1) < 1.2 * most);
    }

    void aBakeThatIsCancelledGoesOnLater()
    {
        Air air(smallPlan());
        std::stop_source source;
        const Status stopped = air.bake(100, source.get_token(), [&](double share) {
            if (share > 0.3) {
                source.request_stop();
            }
        });
        QVERIFY(!stopped.ok() && stopped.error().code == ErrorCode::Cancelled);
        QVERIFY(air.bakedSteps() < 40);
        double last = 0.0;
        QVERIFY(air.bake(100, {}, [&](double share) {
                       QVERIFY(share >= last);
                       last = share;
                   })
                    .ok());
        QCOMPARE(last, 1.0);
        Air whole(smallPlan());
        QVERIFY(bitsAt(air, 100) == bitsAt(whole, 100));
    }

    void fieldsMayBeReadWhileTheyAreBaked()
    {
        Air air(smallPlan());
        Air alone(smallPlan());
        std::jthread baking([&] { (void)air.bake(100); });
        for (std::int64_t step = 100; step > 0; step -= 9) {
            QVERIFY(bitsAt(air, step) == bitsAt(alone, step));
        }
    }
};

QTEST_APPLESS_MAIN(AirTest)
#include "air_test.moc"
