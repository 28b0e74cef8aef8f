#include "core/base/aligned_array.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include <QFile>
#include <QtTest/QtTest>

using namespace fumage;

namespace {

constexpr std::size_t kMebi = std::size_t{1} << 20U;

/// Memory of this program that is really there, MiB; 0 where nobody tells.
std::size_t residentMebi()
{
    QFile file(QStringLiteral("/proc/self/statm"));
    if (!file.open(QIODevice::ReadOnly)) {
        return 0;
    }
    constexpr std::size_t kPage = 4096;
    return static_cast<std::size_t>(file.readAll().split(' ').value(1).toULongLong()) * kPage / kMebi;
}

} // namespace

class AlignedArrayTest : public QObject {
    Q_OBJECT

private slots:
    void everySizeIsAlignedAndHoldsWhatIsWritten()
    {
        for (const std::size_t size :
            {std::size_t{1}, std::size_t{1000}, 4 * kMebi - 1, 4 * kMebi, 4 * kMebi + 1, 7 * kMebi + 12345}) {
            AlignedArray<std::uint8_t> array(size, 7);
            QCOMPARE(reinterpret_cast<std::uintptr_t>(array.data()) % kAlignment, std::uintptr_t{0});
            array.back() = 9;
            QCOMPARE(array.front(), std::uint8_t(size == 1 ? 9 : 7));
            AlignedArray<std::uint8_t> moved = std::move(array);
            QCOMPARE(moved.back(), std::uint8_t(9));
        }
    }

    void tooMuchIsBadAlloc()
    {
        QVERIFY_THROWS_EXCEPTION(std::exception, AlignedArray<float>().resize(std::size_t{1} << 60U));
        QVERIFY_THROWS_EXCEPTION(std::bad_alloc, (void)allocateAligned(static_cast<std::size_t>(-1) - 5));
        QVERIFY_THROWS_EXCEPTION(std::bad_alloc, (void)allocateAligned(std::size_t{1} << 60U));
    }

    void largeArraysLeaveNoHoles()
    {
        if (residentMebi() == 0) {
            QSKIP("this system does not say how much memory a program has");
        }
        // As the air keeps its steps: fields come and go, and now and then something of another size among them.
        const std::size_t before = residentMebi();
        std::vector<AlignedArray<std::uint8_t>> fields;
        std::vector<AlignedArray<std::uint8_t>> states;
        constexpr std::size_t kFields = 40;
        std::size_t most = 0;
        for (std::size_t i = 0; i < 300; ++i) {
            fields.emplace_back(4 * kMebi + 200000, 1);
            if (fields.size() > kFields) {
                fields.erase(fields.begin());
            }
            if (i % 16 == 0) {
                states.emplace_back(11 * kMebi, 1);
            }
            if (i % 64 == 63) {
                states.erase(states.begin(), states.begin() + 3);
            }
            most = std::max(most, residentMebi() - before - states.size() * 11);
        }
        const std::size_t expected = (kFields + 1) * 43 / 10;
        qInfo("%zu MiB for %zu", most, expected);
        QVERIFY(most < expected * 12 / 10);
        fields.clear();
        states.clear();
        QVERIFY(residentMebi() < before + 20);
    }
};

QTEST_APPLESS_MAIN(AlignedArrayTest)
#include "aligned_array_test.moc"
