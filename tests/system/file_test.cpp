#include "tests/helpers.h"

#include "core/system/child_errors.h"
#include "core/system/file.h"
#include "core/system/file_draft.h"
#include "core/system/file_error.h"
#include "core/base/memory.h"
#include "core/system/open_file.h"
#include "core/system/path.h"

#include <QTemporaryDir>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <set>
#include <system_error>

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

class FileTest : public QObject {
    Q_OBJECT

private slots:
    void fileRoundTripAndReplacement()
    {
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.path().toStdString() + "/a.txt";
        QVERIFY(writeFileAtomically(path, std::string_view("one")));
        QVERIFY(writeFileAtomically(path, std::string_view("second")));
        QCOMPARE(readFile(path, 100).value(), std::string("second"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
    }

    void whatTryingAgainMayMendIsToldFromWhatItCannot()
    {
        using enum ErrorCode;
        // Of these the command line says "try again"; of all others that it is of no use.
        const std::set<ErrorCode> passing{DiskFull, OutOfMemory, ReadFailed, WriteFailed};
        for (const int number :
            {EAGAIN, EMFILE, ENFILE, ENOMEM, ENOBUFS, ENOSPC, EDQUOT, EFBIG, EIO, EBUSY, ESTALE, ETIMEDOUT, EINTR}) {
            for (const FileUse use : {FileUse::Read, FileUse::Write}) {
                const Error error = fileError(number, "a", use == FileUse::Read ? ReadFailed : WriteFailed, use);
                QVERIFY2(passing.contains(error.code), std::strerror(number));
            }
            QVERIFY2(passing.contains(childNotStarted(number, "ffmpeg", "").code) || number == EIO || number == EBUSY
                    || number == ESTALE || number == ETIMEDOUT || number == EINTR,
                std::strerror(number));
        }
        for (const int number : {ENOENT, EACCES, EPERM, EROFS, EISDIR, ENOTDIR, ELOOP, ENAMETOOLONG, EINVAL, EILSEQ,
                 ENODEV, ENXIO, ENOSYS, ENOTSUP, EXDEV, EOVERFLOW, ENOEXEC}) {
            for (const FileUse use : {FileUse::Read, FileUse::Write}) {
                const Error error = fileError(number, "a", use == FileUse::Read ? ReadFailed : WriteFailed, use);
                QVERIFY2(!passing.contains(error.code), std::strerror(number));
                QVERIFY2(!error.remedy.empty(), std::strerror(number));
            }
            QVERIFY2(!passing.contains(childNotStarted(number, "ffmpeg", "").code), std::strerror(number));
        }
        for (const std::errc lack :
            {std::errc::resource_unavailable_try_again, std::errc::too_many_files_open, std::errc::not_enough_memory}) {
            const auto refused = withinMemory([&]() -> Status { throw std::system_error(std::make_error_code(lack)); });
            QVERIFY(!refused && refused.error().code == OutOfMemory
                && refused.error().text().find("threads") != std::string::npos && !refused.error().remedy.empty());
        }
        QCOMPARE(withinMemory(
                     []() -> Status { throw std::system_error(std::make_error_code(std::errc::permission_denied)); })
                     .error()
                     .code,
            PermissionDenied);
    }

    void namesThatAreTooLongAreNotTriedAgain()
    {
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath(QString(300, 'x')).toStdString();
        QCOMPARE(readFile(path, 100).error().code, ErrorCode::NotAFile);
        QCOMPARE(writeFileAtomically(path, std::string_view("x")).error().code, ErrorCode::NotAFile);
        QCOMPARE(makeFolderOf(path / "a").error().code, ErrorCode::NotAFile);
    }

    void partsOfAFileAreReadFromAnyPlace()
    {
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("a").toStdString();
        QVERIFY(writeFileAtomically(path, std::string_view("0123456789")));
        const OpenFile file = OpenFile::open(path).value();
        QCOMPARE(file.readAt(7, 2).value(), std::string("78"));
        QCOMPARE(file.readAt(0, 3).value(), std::string("012"));
        QCOMPARE(file.readAt(8, std::size_t{1} << 40U).value(), std::string("89"));
        QVERIFY(file.readAt(10, 1).value().empty() && file.readAt(std::uint64_t{1} << 40U, 1).value().empty());
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
        QCOMPARE(
            writeFileAtomically(base + "/no/such/folder", std::string_view("x")).error().code, ErrorCode::FileNotFound);
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
                FileDraft given =
                    FileDraft::make(path, bytesOf("rubbish"), FileAccess::Usual, FileDraft::Naming(naming)).value();
            }
            FileDraft draft =
                FileDraft::make(path, bytesOf(text), FileAccess::Usual, FileDraft::Naming(naming)).value();
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
            const Result<FileDraft> draft =
                FileDraft::make(base + "/a.txt", bytesOf("half"), FileAccess::Usual, FileDraft::Naming::Temporary);
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
        QCOMPARE(writeFileAtomically(base + "/" + std::string(256, 'n'), std::string_view("x")).error().message.text(),
            std::string("cannot write: the name is too long"));
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
        QVERIFY(writeFileAtomically(base + "/round", std::string_view("x")).error().message.text().find("circle")
            != std::string::npos);
        QVERIFY(readFile(base + "/round", 100).error().message.text().find("circle") != std::string::npos);
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
            QCOMPARE(error.message.text(), std::string("cannot write: it is not a regular file"));
        }
        QCOMPARE(writeFileAtomically(base + "/none/a", std::string_view("x")).error().place.text(), base + "/none");
        QCOMPARE(fileError(EROFS, "a", ErrorCode::WriteFailed, FileUse::Write).message.text(),
            std::string("cannot write: the disk is read-only"));
        std::filesystem::permissions(base, std::filesystem::perms(0555));
        const pid_t writer = fork();
        if (writer == 0) {
            static_cast<void>(seteuid(65534)); // root may write anywhere
            const Status status = writeFileAtomically(base + "/a", std::string_view("x"));
            _exit(!status && status.error().code == ErrorCode::PermissionDenied && status.error().place.text() == base
                    ? 0
                    : 1);
        }
        int result = 1;
        QVERIFY(waitpid(writer, &result, 0) == writer);
        QCOMPARE(result, 0);
        std::filesystem::permissions(base, std::filesystem::perms(0755));
    }

    void filesThatAreWrittenAtOnceStayTogether()
    {
        const QTemporaryDir folder;
        const std::string base = folder.path().toStdString();
        const auto write = [&](char mark) {
            const std::string one(100, mark);
            const std::string other(200, mark);
            const std::array<FileContents, 2> files{{{base + "/one", bytesOf(one)}, {base + "/other", bytesOf(other)}}};
            return writeTogetherAtomically(files);
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

    void aPathHasTheLettersOfItsText()
    {
        const QTemporaryDir folder;
        const QString name = QStringLiteral(u"r\u00f6k \u70df \U0001f525.txt");
        QVERIFY(writeFileAtomically(
            pathFrom(folder.path().toStdString()) / pathFrom(name.toStdString()), std::string_view("smoke")));
        QCOMPARE(namesIn(folder), QStringList(name));
        QCOMPARE(pathFrom("\xff\xfe.txt").native(), std::string("\xff\xfe.txt"));
        QVERIFY(pathFrom("").empty());
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
};

QTEST_GUILESS_MAIN(FileTest)
#include "file_test.moc"
