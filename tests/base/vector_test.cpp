#include "tests/helpers.h"

#include "core/base/hash.h"
#include "core/base/vector.h"

#include <cmath>

using namespace fumage;
using namespace fumage::tests;

class VectorTest : public QObject {
    Q_OBJECT

private slots:
    void planeBasisIsOrthonormal()
    {
        for (std::uint32_t i = 0; i < 500; ++i) {
            const glm::vec3 n = glm::normalize(glm::vec3(
                signedFloat(mixBits(i)), signedFloat(mixBits(i + 1000)), signedFloat(mixBits(i + 2000)) + 1e-3F));
            const PlaneBasis b = planeBasis(n);
            QVERIFY(std::abs(glm::dot(n, b.across)) < 1e-6F && std::abs(glm::dot(n, b.along)) < 1e-6F
                && std::abs(glm::dot(b.across, b.along)) < 1e-6F);
            QVERIFY(std::abs(glm::dot(b.across, b.across) - 1.0F) < 1e-6F
                && std::abs(glm::dot(b.along, b.along) - 1.0F) < 1e-6F);
        }
        QCOMPARE(planeBasis({0.0F, 1.0F, 0.0F}).across, glm::vec3(1.0F, 0.0F, 0.0F));
        QCOMPARE(planeBasis({0.0F, 1.0F, 0.0F}).along, glm::vec3(0.0F, 0.0F, 1.0F));
    }
};

QTEST_GUILESS_MAIN(VectorTest)
#include "vector_test.moc"
