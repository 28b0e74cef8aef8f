// Air that is baked on one thread and read on others: short, so that ThreadSanitizer gets through.

#include "tests/flow/air_helpers.h"

#include <thread>

#include <QtTest/QtTest>

using namespace fumage;
using namespace fumage::tests;

class AirThreadsTest : public QObject {
    Q_OBJECT

private slots:
    void fieldsMayBeReadWhileTheyAreBaked_data()
    {
        QTest::addColumn<int>("loopSteps");
        QTest::addColumn<int>("budget");
        QTest::newRow("once") << 0 << 512000000;
        QTest::newRow("beyond the budget") << 0 << 200000;
        QTest::newRow("in a loop") << 20 << 512000000;
        QTest::newRow("in a loop beyond the budget") << 20 << 200000;
    }

    void fieldsMayBeReadWhileTheyAreBaked()
    {
        QFETCH(int, loopSteps);
        QFETCH(int, budget);
        const AirPlan plan = smallPlan(loopSteps, {9, 12, 8});
        BakedAir air(plan, static_cast<std::size_t>(budget));
        BakedAir alone(plan);
        std::jthread baking([&] { (void)air.bake(40); });
        for (std::int64_t step = 40; step > 0; step -= 7) {
            QVERIFY(bitsAt(air, step) == bitsAt(alone, step));
        }
    }
};

QTEST_APPLESS_MAIN(AirThreadsTest)
#include "air_threads_test.moc"
