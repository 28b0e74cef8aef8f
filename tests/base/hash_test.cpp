#include "tests/helpers.h"

#include "core/base/hash.h"

#include <bit>
#include <cmath>

using namespace fumage;
using namespace fumage::tests;

class HashTest : public QObject {
    Q_OBJECT

private slots:
    void mixedBitsFlipHalfOfTheOutput()
    {
        double flipped = 0.0;
        for (std::uint32_t x = 1; x <= 1000; ++x) {
            for (unsigned bit = 0; bit < 32; ++bit) {
                flipped += std::popcount(mixBits(x) ^ mixBits(x ^ 1U << bit));
            }
        }
        QVERIFY(std::abs(flipped / 32000.0 - 16.0) < 0.1);
    }

    void unitFloatsReachNoughtAndNeverOne()
    {
        QCOMPARE(unitFloat(0U), 0.0F);
        QVERIFY(unitFloat(0xffffffffU) < 1.0F);
        QCOMPARE(signedFloat(0x80000000U), -1.0F);
        QCOMPARE(signedFloat(0x7fffffffU), 1.0F);
    }
};

QTEST_GUILESS_MAIN(HashTest)
#include "hash_test.moc"
