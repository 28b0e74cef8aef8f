// The command line as its users meet it: exit codes, messages, files.

#include "tests/helpers.h"

#include "core/base/file.h"
#include "core/preset/preset.h"

#include <QProcess>
#include <QTemporaryDir>

#include <csignal>

using namespace fumage;

namespace {

struct Outcome {
    int code = -1;
    QByteArray out;
    QByteArray error;
};

Outcome run(const QStringList& arguments, const QString& wrapper = {})
{
    QProcess process;
    if (wrapper.isEmpty()) {
        process.start(FUMAGE_CLI, arguments);
    } else {
        process.start("bash", QStringList{"-c", wrapper, FUMAGE_CLI} + arguments);
    }
    process.waitForFinished(120000);
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1, process.readAllStandardOutput(), process.readAllStandardError()};
}

const QStringList kSmall{"--size", "48", "--set", "emitter.count=500", "--set", "noise.slices=4", "--set", "noise.resolution=16"};

/// Hash of everything in a folder.
QByteArray contents(const QString& folder)
{
    QByteArray all;
    const QDir dir(folder);
    for (const QString& name : dir.entryList(QDir::Files, QDir::Name)) {
        QFile file(dir.filePath(name));
        if (file.open(QIODevice::ReadOnly)) {
            all += name.toUtf8() + file.readAll();
        }
    }
    return all;
}

} // namespace

class CliTest : public QObject {
    Q_OBJECT

private slots:
    void helpNamesEveryCommand()
    {
        const Outcome help = run({"--help"});
        QCOMPARE(help.code, 0);
        for (const char* command : {"render", "flipbook", "bake-noise", "dump", "validate", "info", "presets", "parameters", "schema"}) {
            QVERIFY2(help.out.contains(command), command);
            QCOMPARE(run({command, "--help"}).code, 0);
        }
        QVERIFY(help.out.contains("Exit codes"));
    }

    void wrongUsageIsTwo()
    {
        QCOMPARE(run({}).code, 2);
        QCOMPARE(run({"rendr"}).code, 2);
        QCOMPARE(run({"render"}).code, 2);
        QCOMPARE(run({"render", "default", "--format", "gif"}).code, 2);
        QCOMPARE(run({"dump", "default", "--frame", "-1"}).code, 2);
    }

    void badValuesAreThree_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("says");
        const auto row = [](const char* name, const QStringList& arguments, const char* says) { QTest::newRow(name) << arguments << QByteArray(says); };
        row("unknown preset", {"render", "campfir"}, "campfire");
        row("unknown key", {"render", "default", "--set", "motion.wnd=1"}, "motion.wind");
        row("no equals sign", {"render", "default", "--set", "motion.wind"}, "key=value");
        row("NaN", {"render", "default", "--set", "motion.wind=nan"}, "motion.wind");
        row("frames", {"render", "default", "--frames", "9-2"}, "9-2");
        row("size", {"render", "default", "--size", "0x9"}, "0x9");
        row("huge size", {"render", "default", "--size", "99999"}, "8192");
        row("quality", {"render", "default", "--quality", "best"}, "output.quality");
        row("grid", {"flipbook", "default", "--grid", "8x99"}, "8x99");
        row("too few frames", {"flipbook", "default", "--frames", "0-9"}, "64 cells");
        row("simd", {"--simd", "mmx", "render", "default"}, "mmx");
    }
    void badValuesAreThree()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, says);
        const QTemporaryDir folder;
        const Outcome outcome = run(arguments, "cd '" + folder.path() + "' && \"$0\" \"$@\"");
        QCOMPARE(outcome.code, 3);
        QVERIFY2(outcome.error.contains(says), outcome.error.constData());
        QCOMPARE(outcome.error.count('\n'), 1);
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void badFilesAreRefusedWithOneMessage_data()
    {
        QTest::addColumn<QByteArray>("json");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("brackets") << QByteArray(10'000'000, '[');
        QTest::newRow("binary") << QByteArray("\x00\xff\x12", 3);
        QTest::newRow("not UTF-8") << QByteArray("{\"format\": \"\xc3\x28\"}");
        QTest::newRow("truncated") << QByteArray::fromStdString(formatPreset({}).substr(0, 999));
        QTest::newRow("1e999") << QByteArray(R"({"format": "fumage-preset", "version": 1, "motion": {"wind": 1e999}})");
        QTest::newRow("version") << QByteArray(R"({"format": "fumage-preset", "version": 99})");
    }
    void badFilesAreRefusedWithOneMessage()
    {
        QFETCH(QByteArray, json);
        const QTemporaryDir folder;
        const QString preset = folder.path() + "/bad.json";
        const QString picture = folder.path() + "/kept.png";
        QVERIFY(writeFileAtomically(preset.toStdString(), json.toStdString()).ok());
        QVERIFY(writeFileAtomically(picture.toStdString(), std::string_view("precious")).ok());
        const Outcome outcome = run({"render", preset, "-f", "0", "-o", picture});
        QCOMPARE(outcome.code, 3);
        QCOMPARE(outcome.error.count('\n'), 1);
        QVERIFY(outcome.error.contains("bad.json"));
        QCOMPARE(readFile(picture.toStdString(), 100).value(), std::string("precious"));
    }

    void filesThatCannotBeReadOrWrittenAreOne()
    {
        const QTemporaryDir folder;
        QCOMPARE(run({"render", folder.path() + "/none.json"}).code, 1);
        QCOMPARE(run({"render", folder.path() + "/"}).code, 1);
        QCOMPARE(run({"render", "thesis-2012", "-f", "0", "-o", "/proc/nowhere/a.png"}).code, 1);
        QCOMPARE(run({"bake-noise", "thesis-2012", "--size", "16", "-o", folder.path()}).code, 1);
    }

    void noPermissionIsSaidPlainly()
    {
        if (geteuid() == 0) {
            // Root may write anywhere: run as nobody.
            const QTemporaryDir folder;
            const QString command = "cd / && setpriv --reuid=65534 --clear-groups \"$0\" \"$@\"";
            const Outcome outcome = run({"bake-noise", "thesis-2012", "--size", "16", "-o", folder.path() + "/a.png"}, command);
            QCOMPARE(outcome.code, 1);
            QVERIFY2(outcome.error.contains("permission denied"), outcome.error.constData());
        } else {
            const Outcome outcome = run({"bake-noise", "thesis-2012", "--size", "16", "-o", "/a.png"});
            QCOMPARE(outcome.code, 1);
            QVERIFY2(outcome.error.contains("permission denied"), outcome.error.constData());
        }
    }

    void aFullDiskIsSaidPlainlyAndLeavesNothing()
    {
        const QTemporaryDir folder;
        const QString command = "trap '' XFSZ; ulimit -f 1; \"$0\" \"$@\"";
        const Outcome outcome = run(QStringList{"render", "default", "-f", "0", "-o", folder.path() + "/a.exr", "--size", "200", "--set", "emitter.count=500"}, command);
        QCOMPARE(outcome.code, 1);
        QVERIFY2(outcome.error.contains("larger than may be written") || outcome.error.contains("disk is full"), outcome.error.constData());
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void framesAloneEqualFramesOutOfARange()
    {
        const QTemporaryDir all;
        const QTemporaryDir some;
        QCOMPARE(run(QStringList{"render", "default", "-f", "0-29", "-o", all.path() + "/f_##.png"} + kSmall).code, 0);
        QCOMPARE(run(QStringList{"--threads", "1", "render", "default", "-f", "20-29", "-o", some.path() + "/f_##.png"} + kSmall).code, 0);
        for (int i = 0; i < 20; ++i) {
            QVERIFY(QFile::remove(all.path() + QString("/f_%1.png").arg(i, 2, 10, QChar('0'))));
        }
        QVERIFY(!contents(some.path()).isEmpty());
        QCOMPARE(contents(some.path()), contents(all.path()));
    }

    void threadsAndInstructionSetsGiveTheSameFiles()
    {
        QByteArray first;
        for (const QStringList& how : {QStringList{"--threads", "1"}, QStringList{"--threads", "2"}, QStringList{"--threads", "7"}, QStringList{"--simd", "baseline"}}) {
            const QTemporaryDir folder;
            QCOMPARE(run(how + QStringList{"render", "thesis-2012", "-f", "3-4", "-o", folder.path() + "/f.png"} + kSmall).code, 0);
            const Outcome csv = run(how + QStringList{"dump", "thesis-2012", "-f", "40", "--set", "emitter.count=300"});
            QCOMPARE(csv.code, 0);
            const QByteArray here = contents(folder.path()) + csv.out;
            QVERIFY(first.isEmpty() || first == here);
            first = here;
        }
    }

    void presetsShowIsCanonical()
    {
        const QTemporaryDir folder;
        const Outcome shown = run({"presets", "--show", "default"});
        QCOMPARE(shown.code, 0);
        const QString copy = folder.path() + "/copy.json";
        QVERIFY(writeFileAtomically(copy.toStdString(), shown.out.toStdString()).ok());
        QCOMPARE(run({"presets", "--show", copy}).out, shown.out);
        QCOMPARE(run({"validate", "--strict", copy}).code, 0);
    }

    void builtinPresetFilesAreCanonical()
    {
        const QDir presets(FUMAGE_SOURCE_DIR "/resources/presets");
        for (const QString& name : presets.entryList({"*.json"})) {
            QFile file(presets.filePath(name));
            QVERIFY(file.open(QIODevice::ReadOnly));
            QCOMPARE(run({"presets", "--show", presets.filePath(name)}).out, file.readAll());
        }
    }

    void parametersAreListedAsMarkdown()
    {
        const Outcome outcome = run({"parameters", "--markdown"});
        QCOMPARE(outcome.code, 0);
        QFile reference(FUMAGE_SOURCE_DIR "/resources/parameters.md");
        QVERIFY(reference.open(QIODevice::ReadOnly));
        QCOMPARE(outcome.out, reference.readAll());
    }

    void progressIsQuietInAPipe()
    {
        const QTemporaryDir folder;
        const Outcome outcome = run(QStringList{"render", "thesis-2012", "-f", "0-2", "-o", folder.path() + "/f.png"} + kSmall);
        QCOMPARE(outcome.code, 0);
        QVERIFY(outcome.out.isEmpty() && outcome.error.isEmpty());
    }

    void interruptingStopsCleanly()
    {
        const QTemporaryDir folder;
        QProcess process;
        process.start(FUMAGE_CLI, {"render", "default", "-f", "0-100000", "--size", "64", "-o", folder.path() + "/f.png"});
        QTRY_VERIFY_WITH_TIMEOUT(!QDir(folder.path()).entryList({"*.png"}).isEmpty(), 60000);
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(30000));
        QCOMPARE(process.exitCode(), 130);
        for (const QString& name : QDir(folder.path()).entryList(QDir::Files)) {
            QVERIFY2(name.endsWith(".png"), qPrintable(name));
        }
    }
};

QTEST_GUILESS_MAIN(CliTest)
#include "cli_test.moc"
