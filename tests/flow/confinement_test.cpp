// What confinement may and may not do to the air.
#include "tests/flow/flow_helpers.h"
#include "tests/helpers.h"

#include <algorithm>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// Sum of the squares of the velocities.
double motionOf(const AirSolver& air)
{
    double sum = 0.0;
    forCells(air.grid().cells, [&](const glm::ivec3& c) {
        const glm::vec3 v = air.at(c);
        sum += static_cast<double>(glm::dot(v, v));
    });
    return sum;
}

/// The largest curl, 1/s.
double strongestSwirl(const AirSolver& air)
{
    double most = 0.0;
    forCells(air.grid().cells - 2, [&](const glm::ivec3& low) {
        const glm::ivec3 c = low + 1;
        const auto slope = [&](const glm::ivec3& way) { return air.at(c + way) - air.at(c - way); };
        const glm::vec4 x = slope({1, 0, 0});
        const glm::vec4 y = slope({0, 1, 0});
        const glm::vec4 z = slope({0, 0, 1});
        const glm::vec3 curl = glm::vec3(y.z - z.y, z.x - x.z, x.y - y.x) / (2.0F * air.grid().cell);
        most = std::max(most, static_cast<double>(glm::length(curl)));
    });
    return most;
}

/// A puff of cold air that has been blown upwards and rolls up.
void blow(AirSolver& air)
{
    air.set([](const glm::vec3& place) {
        const float distance = glm::distance(place, {0.05F, 0.6F, 0.0F});
        const float speed = 1.5F * std::max(0.0F, 1.0F - distance / 0.35F);
        return glm::vec4(0.1F * speed, speed, 0.0F, 0.0F);
    });
}

AirStep coldStep(float confinement, int stepsASecond)
{
    AirStep step;
    step.dt = 1.0F / static_cast<float>(stepsASecond);
    step.confinement = confinement;
    return step;
}

} // namespace

class ConfinementTest : public QObject {
    Q_OBJECT

private slots:
    void confinementMakesNoEnergyOfNothing_data()
    {
        QTest::addColumn<float>("confinement");
        QTest::addColumn<int>("stepsASecond");
        for (const float confinement : {0.0F, 0.15F, 0.7F, 1.5F, 4.0F, 10.0F}) {
            for (const int rate : {30, 120}) {
                QTest::newRow(qPrintable(QStringLiteral("%1 at %2").arg(static_cast<double>(confinement)).arg(rate)))
                    << confinement << rate;
            }
        }
    }

    void confinementMakesNoEnergyOfNothing()
    {
        QFETCH(float, confinement);
        QFETCH(int, stepsASecond);
        AirSolver air(boxOf({24, 32, 24}, 2.0F), onGround());
        blow(air);
        const AirStep step = coldStep(confinement, stepsASecond);
        const double first = motionOf(air);
        double before = first;
        for (int i = 0; i < 8 * stepsASecond; ++i) {
            air.step(step);
            const double now = motionOf(air);
            QVERIFY2(now <= before * (1.0 + 1e-4),
                qPrintable(QStringLiteral("step %1: %2 to %3").arg(i).arg(before).arg(now)));
            before = now;
        }
        qInfo("%.3f of its energy is left", before / first);
    }

    void confinementSharpensSwirls()
    {
        double without = 0.0;
        for (const float confinement : {0.0F, 0.15F, 0.7F, 1.5F}) {
            AirSolver air(boxOf({24, 32, 24}, 2.0F), onGround());
            blow(air);
            for (int i = 0; i < 60; ++i) {
                air.step(coldStep(confinement, 30));
            }
            const double swirl = strongestSwirl(air);
            qInfo("%.2f: %.3f 1/s", static_cast<double>(confinement), swirl);
            QVERIFY(confinement == 0.0F || swirl > 1.05 * without);
            without = confinement == 0.0F ? swirl : without;
        }
    }
};

QTEST_GUILESS_MAIN(ConfinementTest)
#include "confinement_test.moc"
