#include "tests/helpers.h"

using namespace fumage;
using namespace fumage::tests;

class SimdTest : public QObject {
    Q_OBJECT

private slots:
    void unknownInstructionSetIsRefused()
    {
        const SimdGuard guard;
        QCOMPARE(forceSimdTarget("mmx").error().code, ErrorCode::UnknownName);
        QVERIFY(!availableSimdTargets().empty());
    }
};

QTEST_GUILESS_MAIN(SimdTest)
#include "simd_test.moc"
