#include "tests/helpers.h"

#include "core/base/file.h"
#include "core/base/hash.h"
#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <thread>

#include <QTemporaryDir>

#include <csignal>
#include <sys/resource.h>
#include <unistd.h>

using namespace fumage;
using namespace fumage::tests;

class BaseTest : public QObject {
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

    void floatsRoundTripAsText()
    {
        for (std::uint32_t i = 0; i < 20000; ++i) {
            const auto value = std::bit_cast<float>(mixBits(i));
            if (std::isfinite(value)) {
                QCOMPARE(std::bit_cast<std::uint32_t>(*parseFloat(formatFloat(value))), std::bit_cast<std::uint32_t>(value));
            }
        }
        QCOMPARE(formatFloat(0.1F), std::string("0.1"));
    }

    void rubbishIsNoNumber()
    {
        for (const char* text : {"", " 1", "1 ", "1,5", "0x10", "--1", "+-1", "one", "1e"}) {
            QVERIFY2(!parseFloat(text), text);
        }
        QCOMPARE(*parseFloat("+1.5"), 1.5F);
        QVERIFY(!parseInteger("99999999999999999999"));
    }

    void nearestNameFindsASlip()
    {
        const std::array<std::string_view, 3> names{"motion.wind", "motion.gravity", "look.size"};
        QCOMPARE(nearestName("motion.wnd", names), std::string_view("motion.wind"));
        QCOMPARE(nearestName("xyzzy", names), std::string_view());
    }

    void planeBasisIsOrthonormal()
    {
        for (std::uint32_t i = 0; i < 500; ++i) {
            const glm::vec3 n = glm::normalize(glm::vec3(signedFloat(mixBits(i)), signedFloat(mixBits(i + 1000)), signedFloat(mixBits(i + 2000)) + 1e-3F));
            const PlaneBasis b = planeBasis(n);
            QVERIFY(std::abs(glm::dot(n, b.across)) < 1e-6F && std::abs(glm::dot(n, b.along)) < 1e-6F && std::abs(glm::dot(b.across, b.along)) < 1e-6F);
            QVERIFY(std::abs(glm::dot(b.across, b.across) - 1.0F) < 1e-6F && std::abs(glm::dot(b.along, b.along) - 1.0F) < 1e-6F);
        }
        QCOMPARE(planeBasis({0.0F, 1.0F, 0.0F}).across, glm::vec3(1.0F, 0.0F, 0.0F));
        QCOMPARE(planeBasis({0.0F, 1.0F, 0.0F}).along, glm::vec3(0.0F, 0.0F, 1.0F));
    }

    void fileRoundTripAndReplacement()
    {
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.path().toStdString() + "/a.txt";
        QVERIFY(writeFileAtomically(path, std::string_view("one")));
        QVERIFY(writeFileAtomically(path, std::string_view("second")));
        QCOMPARE(readFile(path, 100).value(), std::string("second"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
    }

    void unreadableFilesAreErrorsThatNameThem()
    {
        const QTemporaryDir folder;
        const std::string base = folder.path().toStdString();
        QCOMPARE(readFile(base + "/none", 100).error().code, ErrorCode::FileNotFound);
        QCOMPARE(readFile(base, 100).error().code, ErrorCode::NotAFile);
        QCOMPARE(readFile("/dev/zero", 100).error().code, ErrorCode::NotAFile);
        QVERIFY(writeFileAtomically(base + "/big", std::string_view("0123456789")));
        const Error error = readFile(base + "/big", 9).error();
        QCOMPARE(error.code, ErrorCode::TooLarge);
        QVERIFY(error.text().find("/big") != std::string::npos);
        QCOMPARE(writeFileAtomically(base, std::string_view("x")).error().code, ErrorCode::NotAFile);
        QCOMPARE(writeFileAtomically(base + "/no/such/folder", std::string_view("x")).error().code, ErrorCode::FileNotFound);
    }

    void aFullDiskLeavesTheOldFile()
    {
        // A limit on the size of files fails after so many bytes, as a full disk does.
        const QTemporaryDir folder;
        const std::string path = folder.path().toStdString() + "/kept.txt";
        QVERIFY(writeFileAtomically(path, std::string_view("precious")));
        rlimit before{};
        getrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit small{4096, before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
        const Status status = writeFileAtomically(path, std::string(100000, 'x'));
        setrlimit(RLIMIT_FSIZE, &before);
        QVERIFY(!status);
        QCOMPARE(status.error().code, ErrorCode::DiskFull);
        QCOMPARE(readFile(path, 100).value(), std::string("precious"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
    }

    void unknownInstructionSetIsRefused()
    {
        QCOMPARE(forceSimdTarget("mmx").error().code, ErrorCode::UnknownName);
        QVERIFY(!availableSimdTargets().empty());
    }

    void computingGivesWayToTheFirstThread()
    {
        const auto lowestPriority = [] {
            std::atomic<int> nice{-100};
            std::thread([&] {
                parallelFor(1000, [&](std::size_t) {
                    int seen = nice.load();
                    const int mine = getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
                    while (mine > seen && !nice.compare_exchange_weak(seen, mine)) {
                    }
                });
            }).join();
            return nice.load();
        };
        const int before = getpriority(PRIO_PROCESS, 0);
        QCOMPARE(lowestPriority(), before);
        computeInBackground();
        QVERIFY(lowestPriority() > before);
        parallelFor(1000, [](std::size_t) {});
        QCOMPARE(getpriority(PRIO_PROCESS, 0), before);
    }
};

QTEST_GUILESS_MAIN(BaseTest)
#include "base_test.moc"
