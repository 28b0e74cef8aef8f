#include "tests/helpers.h"

#include "core/base/file_draft.h"
#include "core/base/file_error.h"
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
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace fumage;
using namespace fumage::tests;

namespace {

std::span<const std::byte> bytesOf(std::string_view text)
{
    return std::as_bytes(std::span(text.data(), text.size()));
}

QStringList namesIn(const QTemporaryDir& folder)
{
    return QDir(folder.path()).entryList(QDir::Files | QDir::Hidden | QDir::System, QDir::Name);
}

mode_t modeOf(const std::string& path)
{
    struct stat information { };
    return ::stat(path.c_str(), &information) == 0 ? information.st_mode & 07777U : 0;
}

} // namespace

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

    void aDraftTakesItsPlaceOnlyWhenPublished_data()
    {
        QTest::addColumn<int>("naming");
        QTest::newRow("without a name") << int(FileDraft::Naming::None);
        QTest::newRow("with a temporary name") << int(FileDraft::Naming::Temporary);
    }
    void aDraftTakesItsPlaceOnlyWhenPublished()
    {
        QFETCH(int, naming);
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.path().toStdString() + "/a.txt";
        for (const std::string_view text : {"one", "second"}) {
            {
                FileDraft given = FileDraft::make(path, bytesOf("rubbish"), FileAccess::Usual, FileDraft::Naming(naming)).value();
            }
            FileDraft draft = FileDraft::make(path, bytesOf(text), FileAccess::Usual, FileDraft::Naming(naming)).value();
            QVERIFY(readFile(path, 100).ok() == (text == "second"));
            clearLeftovers(folder.path().toStdString()); // its writer lives
            QVERIFY(draft.publish().ok());
            QCOMPARE(readFile(path, 100).value(), std::string(text));
        }
        QCOMPARE(namesIn(folder), QStringList{"a.txt"});
    }

    void whatAKilledWriterLeavesIsClearedAway()
    {
        const QTemporaryDir folder;
        const std::string base = folder.path().toStdString();
        QVERIFY(writeFileAtomically(base + "/.fumage", std::string_view("not ours")));
        const pid_t writer = fork();
        if (writer == 0) {
            const Result<FileDraft> draft = FileDraft::make(base + "/a.txt", bytesOf("half"), FileAccess::Usual, FileDraft::Naming::Temporary);
            _exit(draft ? 0 : 1);
        }
        int status = 1;
        QVERIFY(waitpid(writer, &status, 0) == writer && status == 0);
        QCOMPARE(namesIn(folder).size(), 2);
        QVERIFY(makeFolderOf(base + "/b.txt").ok());
        QCOMPARE(namesIn(folder), QStringList{".fumage"});
    }

    void modeIsKeptAndLongNamesAreWritten()
    {
        const QTemporaryDir folder;
        const std::string base = folder.path().toStdString();
        const mode_t mask = umask(027);
        for (const std::size_t length : {1U, 245U, 255U}) {
            const std::string path = base + "/" + std::string(length, 'n');
            QVERIFY(writeFileAtomically(path, std::string_view("one")).ok());
            QCOMPARE(modeOf(path), mode_t(0640));
            chmod(path.c_str(), 0604);
            QVERIFY(writeFileAtomically(path, std::string_view("two")).ok());
            QCOMPARE(modeOf(path), mode_t(0604));
            QVERIFY(writeFileAtomically(path, std::string_view("three"), FileAccess::Private).ok());
            QCOMPARE(modeOf(path), mode_t(0600));
        }
        umask(mask);
        QCOMPARE(writeFileAtomically(base + "/" + std::string(256, 'n'), std::string_view("x")).error().message, std::string("cannot write: the name is too long"));
        QCOMPARE(namesIn(folder).size(), 3);
    }

    void ownerIsKeptWhenRootSaves()
    {
        if (geteuid() != 0) {
            return; // nobody else may give a file away
        }
        const QTemporaryDir folder;
        const std::string path = folder.path().toStdString() + "/theirs";
        QVERIFY(writeFileAtomically(path, std::string_view("one")).ok());
        constexpr uid_t kNobody = 65534;
        QCOMPARE(chown(path.c_str(), kNobody, kNobody), 0);
        chmod(path.c_str(), 0600);
        QVERIFY(writeFileAtomically(path, std::string_view("two")).ok());
        struct stat information { };
        QCOMPARE(stat(path.c_str(), &information), 0);
        QCOMPARE(information.st_uid, kNobody);
        QCOMPARE(information.st_gid, kNobody);
        QCOMPARE(modeOf(path), mode_t(0600));
    }

    void linksStayLinks()
    {
        const QTemporaryDir folder;
        const std::string base = folder.path().toStdString();
        std::filesystem::create_directory(base + "/far");
        std::filesystem::create_symlink("far/target", base + "/link");
        std::filesystem::create_symlink("link", base + "/chain");
        for (const std::string_view text : {"made", "replaced"}) { // the link dangles at first
            QVERIFY(writeFileAtomically(base + "/chain", text).ok());
            QCOMPARE(readFile(base + "/far/target", 100).value(), std::string(text));
            QVERIFY(std::filesystem::is_symlink(base + "/link") && std::filesystem::is_symlink(base + "/chain"));
        }
        std::filesystem::create_symlink("round", base + "/round");
        QVERIFY(writeFileAtomically(base + "/round", std::string_view("x")).error().message.find("circle") != std::string::npos);
        QVERIFY(readFile(base + "/round", 100).error().message.find("circle") != std::string::npos);
        std::filesystem::create_hard_link(base + "/far/target", base + "/other");
        QVERIFY(writeFileAtomically(base + "/far/target", std::string_view("new")).ok());
        QCOMPARE(readFile(base + "/other", 100).value(), std::string("replaced"));
    }

    void errorsOfWritingBlameWhatIsToBlame()
    {
        const QTemporaryDir folder;
        const std::string base = folder.path().toStdString();
        QCOMPARE(mkfifo((base + "/fifo").c_str(), 0600), 0);
        for (const std::string& path : {base + "/fifo", std::string("/dev/full")}) {
            const Error error = writeFileAtomically(path, std::string_view("x")).error();
            QCOMPARE(error.code, ErrorCode::NotAFile);
            QCOMPARE(error.message, std::string("cannot write: it is not a regular file"));
        }
        QCOMPARE(writeFileAtomically(base + "/none/a", std::string_view("x")).error().place, base + "/none");
        QCOMPARE(fileError(EROFS, "a", ErrorCode::WriteFailed, "write").message, std::string("cannot write: the disk is read-only"));
        std::filesystem::permissions(base, std::filesystem::perms(0555));
        const pid_t writer = fork();
        if (writer == 0) {
            static_cast<void>(seteuid(65534)); // root may write anywhere
            const Status status = writeFileAtomically(base + "/a", std::string_view("x"));
            _exit(!status && status.error().code == ErrorCode::PermissionDenied && status.error().place == base ? 0 : 1);
        }
        int result = 1;
        QVERIFY(waitpid(writer, &result, 0) == writer);
        QCOMPARE(result, 0);
        std::filesystem::permissions(base, std::filesystem::perms(0755));
    }

    void pairsThatAreWrittenAtOnceStayPairs()
    {
        const QTemporaryDir folder;
        const std::string base = folder.path().toStdString();
        const auto write = [&](char mark) {
            const std::string one(100, mark);
            const std::string other(200, mark);
            return writePairAtomically({base + "/one", bytesOf(one)}, {base + "/other", bytesOf(other)});
        };
        for (int round = 0; round < 20; ++round) {
            std::vector<pid_t> writers;
            for (const char mark : {'a', 'b', 'c'}) {
                writers.push_back(fork());
                if (writers.back() == 0) {
                    _exit(write(mark) ? 0 : 1);
                }
            }
            for (const pid_t writer : writers) {
                int status = 1;
                QVERIFY(waitpid(writer, &status, 0) == writer && status == 0);
            }
            QCOMPARE(readFile(base + "/one", 1000).value()[0], readFile(base + "/other", 1000).value()[0]);
        }
        QCOMPARE(namesIn(folder).size(), 2);
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
