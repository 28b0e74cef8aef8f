#include "tests/helpers.h"

#include "core/base/math.h"

#include <cmath>

using namespace fumage;
using namespace fumage::tests;

class MathTest : public QObject {
    Q_OBJECT

private slots:
    void sineAndCosineAreCloseToExact()
    {
        for (double x = -8000.0; x < 8000.0; x += 0.37) {
            const auto f = static_cast<float>(x);
            const double tolerance = 3e-7 + 1e-7 * std::abs(x) / 100.0; // the reduction loses bits for large angles
            QVERIFY(std::abs(static_cast<double>(portableSin(f)) - std::sin(static_cast<double>(f))) < tolerance);
            QVERIFY(std::abs(static_cast<double>(portableCos(f)) - std::cos(static_cast<double>(f))) < tolerance);
        }
    }

    void exponentialAndLogarithmAreCloseToExact()
    {
        for (double x = -80.0; x < 80.0; x += 0.0917) {
            const auto f = static_cast<float>(x);
            QVERIFY(std::abs(static_cast<double>(portableExp(f)) / std::exp(static_cast<double>(f)) - 1.0) < 3e-7);
        }
        for (double x = 1e-30; x < 1e30; x *= 1.37) {
            const auto f = static_cast<float>(x);
            const double exact = std::log(static_cast<double>(f));
            QVERIFY(std::abs(static_cast<double>(portableLog(f)) - exact) < 2e-7 * std::max(1.0, std::abs(exact)));
        }
    }

    void powerOfZero()
    {
        QCOMPARE(portablePow(0.0F, 2.0F), 0.0F);
        QCOMPARE(portablePow(0.0F, 0.0F), 1.0F);
        QVERIFY(std::abs(portablePow(2.0F, 10.0F) - 1024.0F) < 1e-3F);
    }
};

QTEST_GUILESS_MAIN(MathTest)
#include "math_test.moc"
