// How the command line ends when it is told to.

#include "tests/cli/run.h"
#include "tests/helpers.h"

#include <csignal>
#include <map>

#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace fumage;
using namespace fumage::tests;

class CliSignalsTest : public QObject {
    Q_OBJECT

private slots:
    void anInterruptionOfALargePictureIsQuick()
    {
        const QTemporaryDir folder;
        const pid_t program = start({"--threads", "1", "render", "thesis-2012", "-f", "40-45", "--size", "2048",
                                        "--supersample", "2", "-o", folder.path() + "/f.png"},
            STDERR_FILENO);
        QTRY_VERIFY_WITH_TIMEOUT(
            !QDir(folder.path()).entryList({"*.png"}).isEmpty(), 120000); // so the second is being made
        const rusage before = usageOf(program);
        ::kill(program, SIGINT);
        int status = 0;
        rusage after{};
        QCOMPARE(::wait4(program, &status, 0, &after), program);
        QVERIFY(WIFEXITED(status) && WEXITSTATUS(status) == 130);
        // Time of the processor: one such picture takes several times as much.
        QVERIFY2(secondsOf(after) - secondsOf(before) < 0.5,
            QByteArray::number(secondsOf(after) - secondsOf(before)).constData());
    }

    void interruptingADumpThatNobodyReadsEndsIt_data() { signalNumbers(); }
    void interruptingADumpThatNobodyReadsEndsIt()
    {
        QFETCH(int, number);
        int ends[2];
        QCOMPARE(::pipe(ends), 0);
        const pid_t program = start({"dump", "default", "-f", "60"}, ends[1]);
        ::close(ends[1]);
        char byte = 0;
        QCOMPARE(::read(ends[0], &byte, 1), ssize_t(1)); // it writes, and the pipe is soon full
        ::kill(program, number);
        QCOMPARE(exitCodeOf(program), 130);
        ::close(ends[0]);
    }

    void aReaderThatLeavesAListEarlyIsNoFailure_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::newRow("help") << QStringList{"--help"};
        QTest::newRow("presets") << QStringList{"presets"};
        QTest::newRow("presets as JSON") << QStringList{"presets", "--json"};
        QTest::newRow("a preset") << QStringList{"presets", "--show", "default"};
        QTest::newRow("parameters") << QStringList{"parameters"};
        QTest::newRow("parameters as Markdown") << QStringList{"parameters", "--markdown"};
        QTest::newRow("schema") << QStringList{"schema"};
        QTest::newRow("bash") << QStringList{"completions", "bash"};
        QTest::newRow("info") << QStringList{"info", "default"};

        // The commands as the help lists them, up to the next empty line.
        const QString help = QString::fromUtf8(run({"--help"}).out);
        const QString commands = help.section("Subcommands:\n", 1).section("\n\n", 0, 0);
        const QStringList lines = commands.split('\n');
        QVERIFY(lines.size() > 10);
        for (const QString& line : lines) {
            const QString command = line.section(' ', 0, 0, QString::SectionSkipEmpty);
            QTest::newRow(qPrintable("help of " + command)) << QStringList{command, "--help"};
        }
    }
    void aReaderThatLeavesAListEarlyIsNoFailure()
    {
        QFETCH(QStringList, words);
        QCOMPARE(exitCodeOf(start(words, outputThatNobodyReads())), 0);
    }

    void aReaderThatLeavesAPictureEarlyIsAFailure()
    {
        QCOMPARE(exitCodeOf(start(
                     QStringList{"render", "thesis-2012", "-f", "1", "-o", "-"} + kSmall, outputThatNobodyReads())),
            75);
    }

    void theSecondInterruptionEndsAtOnce()
    {
        // A blocked dump takes a moment to see the first; where the machine is slow the second may come too late.
        bool endedAtOnce = false;
        constexpr int kTries = 50;
        for (int i = 0; i < kTries && !endedAtOnce; ++i) {
            int ends[2];
            QCOMPARE(::pipe(ends), 0);
            const pid_t program = start({"dump", "default", "-f", "60"}, ends[1]);
            ::close(ends[1]);
            char byte = 0;
            QCOMPARE(::read(ends[0], &byte, 1), ssize_t(1));
            ::kill(program, SIGINT);
            while (isPending(program)) { }
            ::kill(program, SIGINT);
            int status = 0;
            QCOMPARE(::waitpid(program, &status, 0), program);
            endedAtOnce = WIFSIGNALED(status) && WTERMSIG(status) == SIGINT;
            ::close(ends[0]);
        }
        QVERIFY(endedAtOnce);
    }

    void whatTheParentIgnoresIsIgnored()
    {
        const QTemporaryDir folder;
        const auto pictures = [&] { return QDir(folder.path()).entryList({"*.png"}).size(); };
        const pid_t program = start({"render", "default", "-f", "0-19", "--size", "64", "-o", folder.path() + "/f.png"},
            STDERR_FILENO, {SIGINT, SIGHUP});
        QTRY_VERIFY_WITH_TIMEOUT(pictures() > 0, 120000); // it is at work
        ::kill(program, SIGINT);
        ::kill(program, SIGHUP);
        QCOMPARE(exitCodeOf(program), 0);
        QCOMPARE(pictures(), 20);
    }

    void interruptingStopsCleanly()
    {
        const QTemporaryDir folder;
        QProcess process;
        process.start(
            FUMAGE_CLI, {"render", "default", "-f", "0-100000", "--size", "64", "-o", folder.path() + "/f.png"});
        QTRY_VERIFY_WITH_TIMEOUT(!QDir(folder.path()).entryList({"*.png"}).isEmpty(), 60000);
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(30000));
        QCOMPARE(process.exitCode(), 130);
        for (const QString& name : QDir(folder.path()).entryList(QDir::Files)) {
            QVERIFY2(name.endsWith(".png"), qPrintable(name));
        }
    }

private:
    /// The end of a pipe to write into, whose other end is closed. It stays open until the test ends.
    static int outputThatNobodyReads()
    {
        static const int output = [] {
            int ends[2];
            if (::pipe(ends) != 0) {
                qFatal("there is no pipe");
            }
            ::close(ends[0]);
            return ends[1];
        }();
        return output;
    }

    static void signalNumbers()
    {
        QTest::addColumn<int>("number");
        QTest::newRow("INT") << SIGINT;
        QTest::newRow("TERM") << SIGTERM;
        QTest::newRow("HUP") << SIGHUP;
    }

    /// @param ignored signals that the program is started with
    static pid_t start(const QStringList& arguments, int output, const std::vector<int>& ignored = {})
    {
        std::vector<QByteArray> texts{FUMAGE_CLI};
        for (const QString& argument : arguments) {
            texts.push_back(argument.toLocal8Bit());
        }
        std::vector<char*> pointers;
        for (QByteArray& text : texts) {
            pointers.push_back(text.data());
        }
        pointers.push_back(nullptr);
        std::map<int, sighandler_t> before;
        for (const int number : ignored) {
            before[number] = std::signal(number, SIG_IGN);
        }
        posix_spawn_file_actions_t files;
        posix_spawn_file_actions_init(&files);
        posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
        // Comes back when the program runs: between fork() and exec() a signal would meet the handlers of the test.
        pid_t program = -1;
        if (posix_spawn(&program, FUMAGE_CLI, &files, nullptr, pointers.data(), environ) != 0) {
            qFatal("%s cannot be started", FUMAGE_CLI);
        }
        posix_spawn_file_actions_destroy(&files);
        for (const auto& [number, handler] : before) {
            std::signal(number, handler);
        }
        return program;
    }

    static double secondsOf(const rusage& usage)
    {
        const auto seconds = [](const timeval& time) {
            return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
        };
        return seconds(usage.ru_utime) + seconds(usage.ru_stime);
    }

    /// What a program that runs has used.
    static rusage usageOf(pid_t program)
    {
        rusage usage{};
        QFile stat(QString("/proc/%1/stat").arg(program));
        if (stat.open(QIODevice::ReadOnly)) {
            constexpr int kUserTime = 13;
            const QList<QByteArray> fields = stat.readAll().split(' ');
            const double ticks = fields[kUserTime].toDouble() + fields[kUserTime + 1].toDouble();
            usage.ru_utime.tv_usec = static_cast<suseconds_t>(1e6 * ticks / static_cast<double>(sysconf(_SC_CLK_TCK)));
        }
        return usage;
    }

    /// Whether a signal has been sent and not yet taken.
    static bool isPending(pid_t program)
    {
        QFile status(QString("/proc/%1/status").arg(program));
        return status.open(QIODevice::ReadOnly) && !status.readAll().contains("ShdPnd:\t0000000000000000");
    }

    static int exitCodeOf(pid_t program)
    {
        int status = 0;
        return ::waitpid(program, &status, 0) == program && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
};

QTEST_GUILESS_MAIN(CliSignalsTest)
#include "cli_signals_test.moc"
