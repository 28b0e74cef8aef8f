#include "tests/helpers.h"

#include <map>
#include <set>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// Two chunks in which no two columns hold the same.
Particles distinct()
{
    Particles particles;
    particles.reset(Particles::kChunk + 100, {.rolls = true, .inAir = true, .deforms = true});
    int number = 0;
    forEachColumn([&](const auto& column) {
        ++number;
        std::fill(column.of(particles).begin(), column.of(particles).end(),
            static_cast<std::decay_t<decltype(column.empty)>>(number));
    });
    return particles;
}

} // namespace

class ParticlesTest : public QObject {
    Q_OBJECT

private slots:
    void everyColumnIsVisitedOnceUnderItsName()
    {
        Particles particles = distinct();
        std::map<std::string_view, double> values;
        forEachColumn(
            [&](const auto& column) { values[column.name] = static_cast<double>(column.of(particles).back()); });
        const std::map<std::string_view, double> members{{"x", particles.x.back()}, {"y", particles.y.back()},
            {"z", particles.z.back()}, {"vx", particles.vx.back()}, {"vy", particles.vy.back()},
            {"vz", particles.vz.back()}, {"rollX", particles.rollX.back()}, {"rollY", particles.rollY.back()},
            {"rollZ", particles.rollZ.back()}, {"relativeX", particles.relativeX.back()},
            {"relativeY", particles.relativeY.back()}, {"relativeZ", particles.relativeZ.back()},
            {"heat", particles.heat.back()}, {"shapeXX", particles.shapeXX.back()},
            {"shapeYY", particles.shapeYY.back()}, {"shapeZZ", particles.shapeZZ.back()},
            {"shapeXY", particles.shapeXY.back()}, {"shapeXZ", particles.shapeXZ.back()},
            {"shapeYZ", particles.shapeYZ.back()}, {"key", particles.key.back()},
            {"birthStep", particles.birthStep.back()}};
        QCOMPARE(values, members);
        std::set<double> different;
        for (const auto& [name, value] : values) {
            different.insert(value);
        }
        QCOMPARE(different.size(), std::size_t(21));
    }

    void sameBitsSeesADifferenceInAnyColumn()
    {
        const Particles before = distinct();
        QVERIFY(sameBits(before, before));
        forEachColumn([&](const auto& column) {
            Particles after = before;
            ++column.of(after)[77];
            QVERIFY2(!sameBits(before, after), column.name.data());
        });
        Particles smaller = before;
        --smaller.capacity;
        QVERIFY(!sameBits(before, smaller));
    }

    void resetEmptiesEverySlotAndMakesRollsOnlyWhereAsked()
    {
        for (const bool rolls : {false, true}) {
            Particles particles = distinct();
            particles.reset(5, {.rolls = rolls});
            QCOMPARE(particles.rolls(), rolls);
            QCOMPARE(particles.bytes(), Particles::kChunk * 4 * (rolls ? 11U : 8U));
            forEachColumn([&](const auto& column) {
                const auto& values = column.of(particles);
                QCOMPARE(values.size(),
                    column.owner == ColumnOf::InAir || column.owner == ColumnOf::Deforming
                            || (column.owner == ColumnOf::Rolling && !rolls)
                        ? std::size_t(0)
                        : Particles::kChunk);
                QVERIFY2(std::all_of(values.begin(), values.end(), [&](auto value) { return value == column.empty; }),
                    column.name.data());
            });
            QCOMPARE(particles.birthStep[4], Particles::kUnborn);
        }
    }

    void slotsAreClearedAndCopiedInEveryColumnAndNoFurther()
    {
        const Particles full = distinct();
        Particles some = full;
        some.clear(10, 20);
        Particles back = some;
        back.copySlots(full, 10, 20);
        QVERIFY(sameBits(back, full));
        forEachColumn([&](const auto& column) {
            const auto& values = column.of(some);
            for (std::size_t i = 0; i < 30; ++i) {
                QCOMPARE(values[i], i >= 10 && i < 20 ? column.empty : column.of(full)[i]);
            }
        });
        Particles unrolled = full;
        unrolled.clearRoll(10, 20);
        forEachColumn([&](const auto& column) {
            QCOMPARE(column.of(unrolled)[15], column.owner == ColumnOf::Rolling ? column.empty : column.of(full)[15]);
        });
    }

    void aSparseFrameHasAnEvenShareOfTheParticlesAsTheyAre()
    {
        Frame frame;
        frame.number = 7;
        frame.particles = distinct();
        for (std::size_t slot = 0; slot < frame.particles.capacity; ++slot) {
            frame.particles.key[slot] = static_cast<std::uint32_t>(slot);
            frame.particles.heat[slot] = static_cast<float>(slot);
        }
        for (const double share : {1.0, 0.9, 0.5, 1.0 / 3.0, 0.001}) {
            const Frame few = sparse(frame, share);
            QCOMPARE(few.number, 7);
            const double expected = static_cast<double>(frame.particles.capacity) * share;
            QVERIFY(std::abs(static_cast<double>(few.particles.capacity) - expected) < 1.0);
            QVERIFY(few.particles.columns() == frame.particles.columns());
            for (std::size_t slot = 0; slot < few.particles.capacity; ++slot) {
                const double from = few.particles.key[slot];
                QVERIFY(std::abs(from - static_cast<double>(slot) / share) <= 1.0);
                QCOMPARE(few.particles.heat[slot], static_cast<float>(few.particles.key[slot]));
                QCOMPARE(few.particles.vz[slot], frame.particles.vz[0]);
            }
            for (std::size_t slot = few.particles.capacity; slot < few.particles.birthStep.size(); ++slot) {
                QCOMPARE(few.particles.birthStep[slot], Particles::kUnborn);
            }
        }
    }
};

QTEST_GUILESS_MAIN(ParticlesTest)
#include "particles_test.moc"
