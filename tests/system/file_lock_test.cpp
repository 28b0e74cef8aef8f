#include "core/system/file_lock.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest/QtTest>

#include <sys/wait.h>
#include <unistd.h>

using namespace fumage;

class FileLockTest : public QObject {
    Q_OBJECT

private slots:
    void oneAtATime()
    {
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("work.lock").toStdString();
        std::unique_ptr<FileLock> lock = FileLock::tryTake(file);
        QVERIFY(lock != nullptr);
        QVERIFY(FileLock::tryTake(file) == nullptr);
        lock.reset();
        QVERIFY(!std::filesystem::exists(file));
        QVERIFY(FileLock::tryTake(file) != nullptr);
    }

    void whatWasLeftAloneCanBeHad()
    {
        const QTemporaryDir folder;
        QFile left(folder.filePath("work.lock"));
        QVERIFY(left.open(QIODevice::WriteOnly));
        left.close();
        QVERIFY(FileLock::tryTake(left.fileName().toStdString()) != nullptr);
        QVERIFY(!left.exists());
    }

    void aProgramThatEndsLosesIt()
    {
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("work.lock").toStdString();
        const pid_t child = ::fork();
        if (child == 0) {
            const FileLock* lock = FileLock::tryTake(file).release(); // as if it were killed
            ::_exit(lock != nullptr ? 0 : 1);
        }
        int status = 0;
        QCOMPARE(::waitpid(child, &status, 0), child);
        QVERIFY(WIFEXITED(status) && WEXITSTATUS(status) == 0);
        QVERIFY(std::filesystem::exists(file));
        QVERIFY(FileLock::tryTake(file) != nullptr);
    }

    void aFolderThatIsNotThereHasNone() { QVERIFY(FileLock::tryTake("/no/such/folder/work.lock") == nullptr); }
};

QTEST_APPLESS_MAIN(FileLockTest)
#include "file_lock_test.moc"
