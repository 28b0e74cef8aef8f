// The command line as its users meet it: exit codes, messages, files.

#include "tests/cli/run.h"
#include "tests/helpers.h"

#include "core/base/file.h"
#include "core/effect/parameter_table.h"
#include "core/preset/preset.h"

#include <QDirIterator>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include <csignal>
#include <map>

#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// A file with jobs: $small and $large stand for presets of little smoke, and the size of its picture.
QString writeList(const QTemporaryDir& folder, QString jobs)
{
    Preset preset;
    preset.effect.emitter.count = 300;
    preset.effect.noise.slices = 4;
    preset.effect.noise.resolution = 16;
    for (const auto& [word, edge] : {std::pair{"$small", 32}, std::pair{"$large", 400}}) {
        preset.effect.output.width = preset.effect.output.height = edge;
        jobs.replace(word, "\"preset\": " + QString::fromStdString(formatPreset(preset)));
    }
    const QString file = folder.filePath("list.json");
    const std::string text = R"({"format": "fumage-jobs", "version": 1, "jobs": [)" + jobs.toStdString() + "]}";
    return writeFileAtomically(file.toStdString(), text).ok() ? file : QString();
}

} // namespace

class CliTest : public QObject {
    Q_OBJECT

private slots:
    void helpNamesEveryCommand()
    {
        const Outcome help = run({"--help"});
        QCOMPARE(help.code, 0);
        for (const char* command : {"render", "flipbook", "video", "check-sheet", "fit", "bake-noise", "dump", "volume", "air", "validate", "info", "presets", "parameters", "schema", "verify", "farm", "join"}) {
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
        QCOMPARE(run({"render", "default", "--colour", "red"}).code, 2);
        QCOMPARE(run({"flipbook", "default", "--grid", "4", "--optimise", "4MB"}).code, 2);
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
        row("pass", {"flipbook", "default", "--passes", "colour,sixway"}, "six-way");
        row("no pass", {"flipbook", "default", "--passes", ","}, "--passes");
        row("grid that is no power of two", {"flipbook", "default", "--grid", "6x5", "--power-of-two"}, "6 x 5 cells");
        row("budget without a unit", {"flipbook", "default", "--optimise", "4"}, "--optimise: the budget \"4\" is not understood");
        row("budget that fits nothing", {"flipbook", "thesis-2012", "--optimise", "0.1KB", "-f", "0-9"}, "no sheet fits into 102 bytes");
        row("curve that is none", {"flipbook", "default", "--retime", "fast"}, "--retime: expected a list");
        row("curve beyond the end", {"flipbook", "default", "--retime", "[[0,0],[1,2]]"}, "between 0 and 1");
        row("trimmed loop", {"flipbook", "thesis-2012", "--set", "timeline.loop=true", "--trim"}, "loop");
        row("packed channel", {"flipbook", "default", "--pack", "masks=shadw"}, "--pack: there is no channel \"shadw\". Did you mean \"shadow\"?");
        row("packed without channels", {"flipbook", "default", "--pack", "masks"}, "masks=shadow");
        row("packed under the name of a pass", {"flipbook", "default", "--pack", "motion=alpha"}, "name of a pass");
        row("neither pass nor packed", {"flipbook", "default", "--passes", "none", "-f", "0-63"}, "no pass");
        row("signs of vectors", {"flipbook", "default", "--vectors", "godot"}, "unreal");
        row("too few frames", {"flipbook", "default", "--frames", "0-9"}, "64 cells");
        row("simd", {"--simd", "mmx", "render", "default"}, "mmx");
        row("format", {"render", "default", "--format", "gif"}, "gif");
        row("frame", {"dump", "default", "--frame=-1"}, "-1");
        row("frame in words", {"dump", "default", "--frame", "ten"}, "ten");
        row("supersample", {"render", "default", "--supersample", "0"}, "from 1 to 4");
        row("size 0", {"render", "default", "--size", "0"}, "0");
        row("threads", {"--threads", "0x2", "render", "default"}, "0x2");
        row("size of noise", {"bake-noise", "default", "--size", "4097", "-o", "a.png"}, "4096");
        row("depth that is no number", {"bake-noise", "default", "--depth", "nan", "-o", "a.png"}, "nan");
        row("depth beyond the end", {"bake-noise", "default", "--depth", "1.5", "-o", "a.png"}, "1.5");
    }
    void badValuesAreThree()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, says);
        const QTemporaryDir folder;
        const Outcome outcome = runIn(folder, arguments);
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

    void zerosBeforeANumberChangeNothing()
    {
        const QStringList small{"--set", "emitter.count=50"};
        const QByteArray thirty = run(QStringList{"dump", "default", "--frame", "30"} + small).out;
        QVERIFY(thirty.count('\n') > 10);
        QCOMPARE(run(QStringList{"dump", "default", "--frame", "0030"} + small).out, thirty);
        QCOMPARE(run(QStringList{"dump", "default", "--frame", "0019"} + small).code, 0);
        const auto noise = [](const char* size) { return run({"bake-noise", "default", "--size", size, "-o", "-"}).out; };
        QVERIFY(!noise("010").isEmpty() && noise("010") == noise("10"));
    }

    void clampedSeedsAreSaid()
    {
        const QTemporaryDir folder;
        const QString preset = folder.path() + "/seed.json";
        QVERIFY(writeFileAtomically(preset.toStdString(), QByteArray(R"({"format": "fumage-preset", "version": 1, "emitter": {"seed": -5}})").toStdString()).ok());
        QCOMPARE(run({"validate", "--strict", preset}).code, 3);
        QVERIFY(run({"dump", "default", "--set", "emitter.count=5", "--set", "emitter.seed=1e11"}).error.contains("emitter.seed=1e11: out of range"));
    }

    void fullStandardOutputIsAnError_data()
    {
        QTest::addColumn<QStringList>("arguments");
        for (const QStringList& arguments : {QStringList{"presets"}, QStringList{"presets", "--show", "default"}, QStringList{"validate", "default"}, QStringList{"parameters"},
                 QStringList{"parameters", "--markdown"}, QStringList{"info"}, QStringList{"info", "default"}, QStringList{"schema"}, QStringList{"--help"}, QStringList{"render", "--help"},
                 QStringList{"--version"}, QStringList{"dump", "default", "--set", "emitter.count=5"}}) {
            QTest::newRow(qPrintable(arguments.join(' '))) << arguments;
        }
    }
    void fullStandardOutputIsAnError()
    {
        QFETCH(QStringList, arguments);
        const Outcome outcome = run(arguments, "\"$0\" \"$@\" > /dev/full");
        QCOMPARE(outcome.code, 75); // it may have room another time
        QVERIFY2(outcome.error.contains("standard output cannot be written: No space left"), outcome.error.constData());
        QCOMPARE(outcome.error.count('\n'), 1);
    }

    void namesOfPresetsSteerNoTerminal()
    {
        const QTemporaryDir folder;
        const QString presets = folder.path() + "/fumage/presets";
        QVERIFY(QDir().mkpath(presets));
        Preset preset;
        preset.name = "\x1b[31mred";
        preset.description = "\x1b]0;title\x07\u009b1m";
        QVERIFY(writePresetFile((presets + "/a\x1b[1m.json").toStdString(), preset).ok());
        QVERIFY(writeFileAtomically((presets + "/\x1b[2m.json").toStdString(), std::string_view("{\"\x1b[2m")).ok());
        const QString command = "XDG_DATA_HOME='" + folder.path() + "' \"$0\" \"$@\"";
        for (const QStringList& arguments : {QStringList{"presets"}, QStringList{"info", presets + "/a\x1b[1m.json"}, QStringList{"validate", presets + "/a\x1b[1m.json", presets + "/\x1b[2m.json"}}) {
            const Outcome outcome = run(arguments, command);
            QVERIFY(outcome.out.contains("?["));
            for (const QByteArray& text : {outcome.out, outcome.error}) {
                QVERIFY2(!text.contains('\x1b') && !text.contains('\x07') && !text.contains("\u009b"), text.constData());
            }
        }
    }

    void filesThatCannotBeReadOrWrittenAreOne()
    {
        const QTemporaryDir folder;
        QCOMPARE(run({"render", folder.path() + "/none.json"}).code, 1);
        QCOMPARE(run({"render", folder.path() + "/"}).code, 1);
        QCOMPARE(run({"render", "thesis-2012", "-f", "0", "-o", "/proc/nowhere/a.png"}).code, 1);
        QCOMPARE(run({"bake-noise", "thesis-2012", "--size", "16", "-o", "/proc/nowhere/a.png"}).code, 1);
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
        QCOMPARE(outcome.code, 75);
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

    void aPictureIsThePresetThatItWasMadeOf()
    {
        const QTemporaryDir folder;
        const QStringList changed = kSmall + QStringList{"--set", "motion.gravity=2", "--frames", "5", "-o"};
        QCOMPARE(runIn(folder, QStringList{"render", "default"} + changed + QStringList{"a.png"}).code, 0);
        QCOMPARE(runIn(folder, {"render", "a.png", "--frames", "5", "--size", "48", "-o", "b.png"}).code, 0);
        QCOMPARE(runIn(folder, {"render", "a.png", "--frames", "5", "--size", "48", "-o", "c/"}).code, 0);
        const auto bytes = [&](const char* name) { return readFile((folder.path() + "/" + name).toStdString(), std::size_t{1} << 24U).value(); };
        QVERIFY(bytes("a.png") == bytes("b.png") && bytes("a.png") == bytes("c/a.png"));
        QVERIFY(runIn(folder, {"presets", "--show", "a.png"}).out.contains("\"gravity\": 2"));
        const Outcome over = runIn(folder, {"render", "a.png", "--frames", "5"});
        QVERIFY2(over.code == 3 && over.error.contains("a.png"), over.error);
        QCOMPARE(runIn(folder, QStringList{"render", "default", "--no-preset"} + changed + QStringList{"bare.png"}).code, 0);
        const Outcome bare = runIn(folder, {"render", "bare.png", "-o", "d.png"});
        QVERIFY2(bare.code == 3 && bare.error.contains("carries no preset"), bare.error);
    }

    void fitWritesNothingAndTakesPresetsOfOneName()
    {
        const Outcome twice = run({"fit", "thesis-2012", "thesis-2012", "--frames", "5"});
        QVERIFY2(twice.code == 0 && twice.out.count('\n') == 2, twice.error);
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

    void whatWasWrittenIsSaidInTheLastLine()
    {
        const QTemporaryDir folder;
        const QStringList arguments = QStringList{"render", "thesis-2012", "-f", "0-2", "-o", folder.path() + "/f.png"} + kSmall;
        const Outcome outcome = run(arguments);
        QCOMPARE(outcome.code, 0);
        QVERIFY(outcome.out.isEmpty());
        QCOMPARE(outcome.error, QString("fumage-cli: wrote 3 files, %1/f_0000.png to %1/f_0002.png\n").arg(folder.path()).toUtf8());
        QCOMPARE(run(arguments + QStringList{"-f", "1"}).code, 2); // named twice
        const Outcome quiet = run(QStringList{"--quiet"} + arguments);
        QVERIFY(quiet.code == 0 && quiet.out.isEmpty() && quiet.error.isEmpty());
    }

    void aFitIsPrintedAsOptionsThatKeepAllSmokeInThePicture()
    {
        const QTemporaryDir folder;
        const QStringList smoke{"default", "--set", "emitter.count=500", "--set", "camera.distance=2", "--frames", "20-29", "--size", "48"};
        const auto bookWith = [&](const QStringList& more) { return run(QStringList{"flipbook"} + smoke + QStringList{"--grid", "2", "-o", folder.filePath("a.png")} + more); };
        QVERIFY(bookWith({}).error.contains("cut off"));
        QVERIFY(bookWith({}).error.contains("frames 20 to 27"));
        const Outcome fit = run(QStringList{"fit"} + smoke);
        QCOMPARE(fit.code, 0);
        const QStringList options = QString::fromUtf8(fit.out.trimmed()).split(' ');
        QCOMPARE(options.size(), 4); // target and distance
        QVERIFY(!bookWith(options).error.contains("cut off"));
        QVERIFY(!bookWith({"--fit"}).error.contains("cut off"));
        QCOMPARE(run({"fit", "default", "--frames", "0", "--set", "look.opacity=0"}).code, 3);
    }

    void outputsAreNamedAsTheUserMeans_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QStringList>("files");
        const auto row = [](const char* name, const QStringList& arguments, const QStringList& files) { QTest::newRow(name) << arguments << files; };
        const QStringList two{"render", "thesis-2012", "-f", "7-8", "-o"};
        const QStringList one{"render", "thesis-2012", "-f", "7", "-o"};
        row("capitals", one + QStringList{"x.PNG"}, {"x.PNG"});
        row("exr", one + QStringList{"x.Exr"}, {"x.Exr"});
        row("tga", one + QStringList{"x.TGA"}, {"x.TGA"});
        row("a flipbook in tga", {"flipbook", "thesis-2012", "--grid", "1", "-f", "7", "-o", "x", "--format", "tga"}, {"x.flipbook.json", "x.tga"});
        row("noise in tga", {"bake-noise", "thesis-2012", "-o", "n.tga"}, {"n.tga"});
        row("format without an ending", one + QStringList{"x", "--format", "exr"}, {"x.exr"});
        row("printf", two + QStringList{"x_%03d.png"}, {"x_007.png", "x_008.png"});
        row("printf without width", two + QStringList{"x%d"}, {"x7.png", "x8.png"});
        row("hashes and no ending", two + QStringList{"x.##"}, {"x.07.png", "x.08.png"});
        row("a folder that is there", two + QStringList{"d"}, {"d/thesis-2012_0007.png", "d/thesis-2012_0008.png"});
        row("a folder to be made", one + QStringList{"e/"}, {"e/thesis-2012.png"});
        row("no name", {"render", "thesis-2012", "-f", "7"}, {"thesis-2012.png"});
        row("two presets", {"render", "thesis-2012", "default", "-f", "7", "-o", "d/"}, {"d/default.png", "d/thesis-2012.png"});
        row("flipbook in a folder", {"flipbook", "thesis-2012", "--grid", "1", "-f", "7", "-o", "d"}, {"d/thesis-2012.flipbook.json", "d/thesis-2012.png"});
        row("the best that fits", {"flipbook", "thesis-2012", "--for", "pixi", "-f", "0-9", "--optimise", "4KB", "-o", "d"},
            {"d/thesis-2012_4x2.atlas.json", "d/thesis-2012_4x2.flipbook.json", "d/thesis-2012_4x2.png"});
        row("trimmed and retimed", {"flipbook", "thesis-2012", "--grid", "2", "-f", "0-9", "--trim", "--retime", "[[0,1],[1,0]]", "-o", "x"}, {"x.flipbook.json", "x.png"});
        row("packed pictures", {"flipbook", "--pack", "a=alpha", "thesis-2012", "--pack", "b=depth,1@1/2", "--passes", "none", "--grid", "1", "-f", "7", "-o", "x"}, {"x.flipbook.json", "x_a.png", "x_b.png"});
        row("noise", {"bake-noise", "thesis-2012", "-o", "d"}, {"d/thesis-2012_noise.png"});
        row("particles by the ending", {"dump", "thesis-2012", "-o", "p.ply"}, {"p.ply"});
        row("point cache", {"dump", "thesis-2012", "-o", "p.pcache"}, {"p.pcache"});
        row("volumes", {"volume", "thesis-2012", "--cells", "16", "-f", "0-2:2", "-o", "v_##"}, {"v_00.vdb", "v_02.vdb"});
        row("air", {"air", "plume", "--set", "air.resolution=16", "-o", "plume.vf"}, {"plume.vf"});
        row("air in its default format", {"air", "plume", "--set", "air.resolution=16", "-o", "."}, {"plume.fga"});
        row("particles of several frames", {"dump", "thesis-2012", "-f", "0-4:2", "-o", "p_##.csv"}, {"p_00.csv", "p_02.csv", "p_04.csv"});
    }
    void outputsAreNamedAsTheUserMeans()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QStringList, files);
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkdir("d"));
        const bool isPicture = !QStringList{"dump", "volume", "air"}.contains(arguments[0]);
        const QString small = !isPicture ? " --set emitter.count=20" : " --size 16 --set emitter.count=20 --set noise.slices=1 --set noise.resolution=8";
        const Outcome outcome = run(arguments, "cd '" + folder.path() + "' && \"$0\" \"$@\"" + small);
        QVERIFY2(outcome.code == 0, outcome.error.constData());
        QStringList found;
        QDirIterator at(folder.path(), QDir::Files, QDirIterator::Subdirectories);
        while (at.hasNext()) {
            found += QDir(folder.path()).relativeFilePath(at.next());
        }
        found.sort();
        QCOMPARE(found, files);
        const QByteArray begin = contents(QFileInfo(folder.filePath(files.first())).path());
        QVERIFY(files.first().endsWith("exr", Qt::CaseInsensitive) == begin.contains("\x76\x2f\x31\x01"));
        QVERIFY((files.first().endsWith("ply") || files.first().endsWith("pcache")) == begin.contains("end_header"));
    }

    void badNamesOfOutputsAreRefused_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("says");
        const auto row = [](const char* name, const QStringList& arguments, const char* says) { QTest::newRow(name) << arguments << QByteArray(says); };
        row("jpg", {"render", "default", "-o", "x.jpg"}, "Use .png, .exr or .tga");
        row("noise as jpg", {"bake-noise", "default", "-o", "a.jpg"}, "Use .png, .exr or .tga");
        row("particles as png", {"dump", "default", "-o", "q.png"}, "Use .csv, .ply or .pcache");
        row("ending against format", {"render", "default", "-o", "x.png", "--format", "exr"}, "Use .exr");
        row("particles against format", {"dump", "default", "-o", "x.csv", "--format", "ply"}, "Use .ply");
        row("several pictures to standard output", {"render", "default", "-f", "0-1", "-o", "-"}, "several files");
        row("flipbook to standard output", {"flipbook", "default", "-o", "-"}, "several files");
        row("several dumps to standard output", {"dump", "default", "-f", "0-1"}, "several files");
        row("two presets into one file", {"render", "default", "thesis-2012", "-o", "x.png"}, "folder");
    }
    void badNamesOfOutputsAreRefused()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, says);
        const QTemporaryDir folder;
        const Outcome outcome = runIn(folder, arguments);
        QCOMPARE(outcome.code, 3);
        QVERIFY2(outcome.error.contains(says), outcome.error.constData());
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void devicesAreNotGivenAnEnding()
    {
        const Outcome outcome = run({"render", "default", "-f", "0", "-o", "/dev/stdout"});
        QCOMPARE(outcome.code, 1);
        QVERIFY2(outcome.error.contains("- for standard output"), outcome.error.constData());
    }

    void aListOfJobsGoesOnAfterOneThatFails()
    {
        const QTemporaryDir folder;
        QVERIFY(writePresetFile(folder.filePath("mine.json").toStdString(), Preset()).ok());
        const QString list = writeList(folder,
            R"({"name": "good", "output": "a/x_#.png", "frames": "0-1", $small},)"
            R"({"name": "nowhere", "output": "/proc/nowhere/b.png", "kind": "picture", $small},)"
            R"({"name": "large", "output": "large.exr", "kind": "picture", $large},)"
            R"({"name": "itself", "output": "c.png", "kind": "picture", "source": "c.png", $small},)"
            R"({"name": "book", "output": "d.png", "kind": "flipbook", "columns": 2, "rows": 1, "frames": "0-3", $small})");
        QVERIFY(QFile::copy(folder.filePath("mine.json"), folder.filePath("c.png")));
        // A limit on the size of files fails as a full disk does.
        const Outcome outcome = run({"render", "--jobs", list, "--json"}, "cd '" + folder.path() + "' && trap '' XFSZ; ulimit -f 60; \"$0\" \"$@\"");
        QCOMPARE(outcome.code, 1);
        QVERIFY2(outcome.error.contains("job 3 of 5: large\n"), outcome.error.constData());
        QVERIFY2(outcome.error.contains("fumage-cli: nowhere: ") && outcome.error.contains("fumage-cli: large: ") && outcome.error.contains("fumage-cli: itself: c.png: this would overwrite"), outcome.error.constData());
        QVERIFY2(outcome.error.trimmed().endsWith(": 3 of 5 jobs failed. Mend what is said above, and do them again"), outcome.error.constData());
        QCOMPARE(QDir(folder.filePath("a")).entryList(QDir::Files), (QStringList{"x_0.png", "x_1.png"}));
        QVERIFY(QFile::exists(folder.filePath("d.flipbook.json")) && !QFile::exists(folder.filePath("large.exr")));
        const QJsonObject answer = QJsonDocument::fromJson(outcome.out).object();
        QCOMPARE(answer["done"].toInt(), 2);
        QCOMPARE(answer["failed"].toInt(), 3);
        const QJsonArray jobs = answer["jobs"].toArray();
        QCOMPARE(jobs.size(), 5);
        QCOMPARE(jobs[0].toObject()["outcome"].toString(), QString("done"));
        QCOMPARE(jobs[0].toObject()["files"].toInt(), 2);
        QCOMPARE(jobs[0].toObject()["last"].toString(), QString("a/x_1.png"));
        QCOMPARE(jobs[1].toObject()["outcome"].toString(), QString("failed"));
        QVERIFY(jobs[2].toObject()["error"].toString().contains("large.exr"));
        QCOMPARE(jobs[4].toObject()["last"].toString(), QString("d.flipbook.json"));
        // All of them done is a success, and standard input will do.
        const Outcome fine = run({"render", "--jobs", "-"}, "cd '" + folder.path() + "' && \"$0\" \"$@\" < " + writeList(folder, R"({"output": "e.png", "kind": "picture", $small})"));
        QVERIFY2(fine.code == 0 && fine.error.trimmed().endsWith("wrote e.png"), fine.error.constData());
    }

    void jobsOfOneFileAreRefusedBeforeAnythingIsRendered()
    {
        const QTemporaryDir folder;
        const QString list = writeList(folder, R"({"name": "one", "output": "a.png", "kind": "picture", $small}, {"name": "two", "output": "./a.png", "kind": "flipbook", "columns": 1, "rows": 1, $small})");
        const Outcome outcome = runIn(folder, {"render", "--jobs", list});
        QCOMPARE(outcome.code, 3);
        QVERIFY2(outcome.error.contains("\"two\" would write over a file of \"one\""), outcome.error.constData());
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"list.json"});
    }

    void aListSaysAllThatOptionsSay()
    {
        const QTemporaryDir folder;
        const QString list = writeList(folder, R"({"output": "a.png", "kind": "picture", $small})");
        QCOMPARE(run({"render", "--jobs", list, "default"}).code, 2);
        QCOMPARE(run({"render", "--jobs", list, "--size", "64"}).code, 2);
        QCOMPARE(run({"render", "default", "--json"}).code, 2);
        QCOMPARE(run({"render", "--jobs", folder.filePath("none.json")}).code, 1);
    }

    void presetsOfOneNameAreNotWrittenOverEachOther()
    {
        const QTemporaryDir folder;
        for (const QString& place : {QStringLiteral("a"), QStringLiteral("b")}) {
            QVERIFY(QDir(folder.path()).mkdir(place));
            QVERIFY(writePresetFile((folder.path() + "/" + place + "/mine.json").toStdString(), Preset()).ok());
        }
        const Outcome outcome = runIn(folder, {"bake-noise", "a/mine.json", "b/mine.json", "-o", "out/"});
        QCOMPARE(outcome.code, 3);
        QVERIFY2(outcome.error.contains("two presets are called \"mine\""), outcome.error.constData());
        QVERIFY(!QDir(folder.filePath("out")).exists());
    }

    void answersCanBeReadByPrograms()
    {
        const auto answer = [](const QStringList& arguments) { return QJsonDocument::fromJson(run(arguments).out); };
        const auto hasOne = [](const QJsonArray& all, const auto& isIt) { return std::any_of(all.begin(), all.end(), isIt); };
        const QJsonArray presets = answer({"presets", "--json"}).array();
        QVERIFY(presets.size() >= 16);
        QVERIFY(hasOne(presets, [](const QJsonValue& one) { return one["id"].toString() == "campfire" && one["builtin"].toBool() && one["loop"].toBool(); }));
        const QJsonObject info = answer({"info", "default", "--json"}).object();
        QCOMPARE(info["frames"].toInt(), Effect().timeline.length);
        QVERIFY(info["changed"].toObject()["air.enabled"].toBool());
        QCOMPARE(answer({"info", "dust", "--json"})["changed"]["emitter.mode"].toString(), QString("burst"));
        QVERIFY(!answer({"info", "--json"})["instructionSets"].toArray().isEmpty());
        const QJsonArray parameters = answer({"parameters", "--json"}).array();
        QCOMPARE(static_cast<std::size_t>(parameters.size()), parameterTable().size());
        QVERIFY(hasOne(parameters, [](const QJsonValue& one) { return one["key"].toString() == "motion.wind" && one["maximum"].toDouble() > 0.0; }));
    }

    void standardStreamsAreADash()
    {
        const QTemporaryDir folder;
        const QStringList small = QStringList{"-f", "7"} + kSmall;
        const Outcome picture = run(QStringList{"render", "default", "-o", "-"} + small);
        QCOMPARE(picture.code, 0);
        QVERIFY(picture.error.isEmpty());
        QCOMPARE(run(QStringList{"render", "default", "-o", folder.path() + "/a.png"} + small).code, 0);
        QVERIFY(contents(folder.path()) == "a.png" + picture.out);
        const QString piped = "\"$0\" presets --show campfire | \"$0\" \"$@\"";
        QCOMPARE(run({"validate", "--strict", "-"}, piped).code, 0);
        QCOMPARE(run(QStringList{"dump", "-", "--set", "emitter.count=50"}, piped).out, run({"dump", "campfire", "--set", "emitter.count=50"}).out);
        QCOMPARE(run({"validate", "-"}, "echo rubbish | \"$0\" \"$@\"").code, 3);
    }

    void aCommandNeverOverwritesItsPreset_data()
    {
        QTest::addColumn<QStringList>("arguments");
        const auto row = [](const char* name, const QStringList& arguments) { QTest::newRow(name) << arguments; };
        row("dump", {"dump", "my.csv", "-o", "my.csv"});
        row("dump through a link", {"dump", "my.csv", "-o", "link.csv"});
        row("dump of frames", {"dump", "p_02.csv", "-f", "0-3", "-o", "p_##.csv"});
        row("noise", {"bake-noise", "my.png", "-o", "my.png"});
        row("render", {"render", "f_0003.png", "-f", "0-5", "-o", "f.png"});
        row("flipbook's description", {"flipbook", "my.flipbook.json", "--grid", "1", "-f", "0", "-o", "my"});
    }
    void aCommandNeverOverwritesItsPreset()
    {
        QFETCH(QStringList, arguments);
        const QTemporaryDir folder;
        const QString preset = folder.filePath(arguments[1]);
        QVERIFY(writePresetFile(preset.toStdString(), Preset()).ok());
        QVERIFY(QFile::link(preset, folder.filePath("link.csv")));
        const QByteArray before = contents(folder.path());
        const Outcome outcome = runIn(folder, arguments);
        QCOMPARE(outcome.code, 3);
        QVERIFY2(outcome.error.contains("overwrite the preset"), outcome.error.constData());
        QVERIFY(contents(folder.path()) == before);
    }

    void slipsInTheNameOfACommandAreAnswered()
    {
        const Outcome slip = run({"rendr", "default"});
        QCOMPARE(slip.code, 2);
        QVERIFY2(slip.error.contains("Did you mean \"render\"?"), slip.error.constData());
        QCOMPARE(run({"help"}).out, run({"--help"}).out);
        QCOMPARE(run({"help", "render"}).out, run({"render", "--help"}).out);
        QCOMPARE(run({"-V"}).out, run({"--version"}).out);
        QVERIFY(!run({"render", "--help"}).out.contains("KEY=VALUE ..."));
    }

    void anInterruptionOfALargePictureIsQuick()
    {
        const QTemporaryDir folder;
        const pid_t program = start({"--threads", "1", "render", "thesis-2012", "-f", "40-45", "--size", "2048", "--supersample", "2", "-o", folder.path() + "/f.png"}, STDERR_FILENO);
        QTRY_VERIFY_WITH_TIMEOUT(!QDir(folder.path()).entryList({"*.png"}).isEmpty(), 120000); // so the second is being made
        const rusage before = usageOf(program);
        ::kill(program, SIGINT);
        int status = 0;
        rusage after{};
        QCOMPARE(::wait4(program, &status, 0, &after), program);
        QVERIFY(WIFEXITED(status) && WEXITSTATUS(status) == 130);
        // Time of the processor: one such picture takes several times as much.
        QVERIFY2(secondsOf(after) - secondsOf(before) < 0.5, QByteArray::number(secondsOf(after) - secondsOf(before)).constData());
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
            while (isPending(program)) {
            }
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
        const pid_t program = start({"render", "default", "-f", "0-19", "--size", "64", "-o", folder.path() + "/f.png"}, STDERR_FILENO, {SIGINT, SIGHUP});
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
        process.start(FUMAGE_CLI, {"render", "default", "-f", "0-100000", "--size", "64", "-o", folder.path() + "/f.png"});
        QTRY_VERIFY_WITH_TIMEOUT(!QDir(folder.path()).entryList({"*.png"}).isEmpty(), 60000);
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(30000));
        QCOMPARE(process.exitCode(), 130);
        for (const QString& name : QDir(folder.path()).entryList(QDir::Files)) {
            QVERIFY2(name.endsWith(".png"), qPrintable(name));
        }
    }

private:
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
        const auto seconds = [](const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
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

QTEST_GUILESS_MAIN(CliTest)
#include "cli_test.moc"
