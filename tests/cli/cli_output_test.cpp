// What the command line writes: names, endings and streams, and what keeps it from writing.

#include "tests/cli/refusals.h"
#include "tests/helpers.h"

#include "core/system/file.h"
#include "core/preset/preset_file.h"

#include <QDirIterator>

#include <unistd.h>

#ifdef __has_feature
#if __has_feature(address_sanitizer)
#define FUMAGE_SANITIZED
#endif
#endif

using namespace fumage;
using namespace fumage::tests;

class CliOutputTest : public QObject {
    Q_OBJECT

private slots:
    void fullStandardOutputIsAnError_data()
    {
        QTest::addColumn<QStringList>("arguments");
        for (const QStringList& arguments : {QStringList{"presets"}, QStringList{"presets", "--show", "default"},
                 QStringList{"validate", "default"}, QStringList{"parameters"}, QStringList{"parameters", "--markdown"},
                 QStringList{"info"}, QStringList{"info", "default"}, QStringList{"schema"}, QStringList{"--help"},
                 QStringList{"render", "--help"}, QStringList{"--version"},
                 QStringList{"dump", "default", "--set", "emitter.count=5"}}) {
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
            const Outcome outcome =
                run({"bake-noise", "thesis-2012", "--size", "16", "-o", folder.path() + "/a.png"}, command);
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
        const Outcome outcome = run(QStringList{"render", "default", "-f", "0", "-o", folder.path() + "/a.exr",
                                        "--size", "200", "--set", "emitter.count=500"},
            command);
        QCOMPARE(outcome.code, 75);
        QVERIFY2(outcome.error.contains("larger than may be written") || outcome.error.contains("disk is full"),
            outcome.error.constData());
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void framesAloneEqualFramesOutOfARange()
    {
        const QTemporaryDir all;
        const QTemporaryDir some;
        QCOMPARE(run(QStringList{"render", "default", "-f", "0-29", "-o", all.path() + "/f_##.png"} + kSmall).code, 0);
        QCOMPARE(run(QStringList{"--threads", "1", "render", "default", "-f", "20-29", "-o", some.path() + "/f_##.png"}
                     + kSmall)
                     .code,
            0);
        for (int i = 0; i < 20; ++i) {
            QVERIFY(QFile::remove(all.path() + QString("/f_%1.png").arg(i, 2, 10, QChar('0'))));
        }
        QVERIFY(!contents(some.path()).isEmpty());
        QCOMPARE(contents(some.path()), contents(all.path()));
    }

    void threadsAndInstructionSetsGiveTheSameFiles()
    {
        QByteArray first;
        for (const QStringList& how : {QStringList{"--threads", "1"}, QStringList{"--threads", "2"},
                 QStringList{"--threads", "7"}, QStringList{"--simd", "baseline"}}) {
            const QTemporaryDir folder;
            QCOMPARE(
                run(how + QStringList{"render", "thesis-2012", "-f", "3-4", "-o", folder.path() + "/f.png"} + kSmall)
                    .code,
                0);
            const Outcome csv = run(how + QStringList{"dump", "thesis-2012", "-f", "40", "--set", "emitter.count=300"});
            QCOMPARE(csv.code, 0);
            const QByteArray here = contents(folder.path()) + csv.out;
            QVERIFY(first.isEmpty() || first == here);
            first = here;
        }
    }

    void aPictureIsThePresetThatItWasMadeOf()
    {
        const QTemporaryDir folder;
        const QStringList changed = kSmall + QStringList{"--set", "motion.gravity=2", "--frames", "5", "-o"};
        QCOMPARE(runIn(folder, QStringList{"render", "default"} + changed + QStringList{"a.png"}).code, 0);
        QCOMPARE(runIn(folder, {"render", "a.png", "--frames", "5", "--size", "48", "-o", "b.png"}).code, 0);
        QCOMPARE(runIn(folder, {"render", "a.png", "--frames", "5", "--size", "48", "-o", "c/"}).code, 0);
        const auto bytes = [&](const char* name) {
            return readFile((folder.path() + "/" + name).toStdString(), std::size_t{1} << 24U).value();
        };
        QVERIFY(bytes("a.png") == bytes("b.png") && bytes("a.png") == bytes("c/a.png"));
        QVERIFY(runIn(folder, {"presets", "--show", "a.png"}).out.contains("\"gravity\": 2"));
        const Outcome over = runIn(folder, {"render", "a.png", "--frames", "5"});
        QVERIFY2(over.code == 3 && over.error.contains("a.png"), over.error);
        QCOMPARE(
            runIn(folder, QStringList{"render", "default", "--no-preset"} + changed + QStringList{"bare.png"}).code, 0);
        const Outcome bare = runIn(folder, {"render", "bare.png", "-o", "d.png"});
        QVERIFY2(bare.code == 3 && bare.error.contains("carries no preset"), bare.error);
    }

    void framesThatAreJoinedUnderAViewTransformHaveNoBackgroundYet()
    {
        const QTemporaryDir folder;
        const QString frames = folder.filePath("f_##.exr");
        QStringList smoke{"thesis-2012", "-f", "3-4", "--set", "output.background=colour", "--set",
            "output.background_colour=[0,1,0]", "--set", "output.width=16", "--set", "output.height=16", "--set",
            "emitter.count=50"};
        const auto join = [&] {
            return run(QStringList{"join"} + smoke
                + QStringList{"--input", frames, "--grid", "1x2", "-o", folder.filePath("s.png")});
        };
        const auto render = [&](const QStringList& more) {
            return run(QStringList{"render"} + smoke + more + QStringList{"-o", frames});
        };
        QCOMPARE(render({}).code, 0);
        QCOMPARE(join().code, 0);
        smoke += QStringList{"--set", "output.view_transform=filmic"};
        QCOMPARE(join().code, 3);
        QVERIFY(join().error.contains("output.background=transparent"));
        QCOMPARE(render({"--set", "output.background=transparent"}).code, 0);
        QCOMPARE(join().code, 0);
    }

    void fitWritesNothingAndTakesPresetsOfOneName()
    {
        const Outcome twice = run({"fit", "thesis-2012", "thesis-2012", "--frames", "5"});
        QVERIFY2(twice.code == 0 && twice.out.count('\n') == 2, twice.error);
    }

    void whatWasWrittenIsSaidInTheLastLine()
    {
        const QTemporaryDir folder;
        const QStringList arguments =
            QStringList{"render", "thesis-2012", "-f", "0-2", "-o", folder.path() + "/f.png"} + kSmall;
        const Outcome outcome = run(arguments);
        QCOMPARE(outcome.code, 0);
        QVERIFY(outcome.out.isEmpty());
        QCOMPARE(outcome.error,
            QString("fumage-cli: wrote 3 files, %1/f_0000.png to %1/f_0002.png\n").arg(folder.path()).toUtf8());
        QCOMPARE(run(arguments + QStringList{"-f", "1"}).code, 2); // named twice
        const Outcome quiet = run(QStringList{"--quiet"} + arguments);
        QVERIFY(quiet.code == 0 && quiet.out.isEmpty() && quiet.error.isEmpty());
    }

    void aFitIsPrintedAsOptionsThatKeepAllSmokeInThePicture()
    {
        const QTemporaryDir folder;
        const QStringList smoke{
            "default", "--set", "emitter.count=500", "--set", "camera.distance=2", "--frames", "20-29", "--size", "48"};
        const auto bookWith = [&](const QStringList& more) {
            return run(
                QStringList{"flipbook"} + smoke + QStringList{"--grid", "2", "-o", folder.filePath("a.png")} + more);
        };
        QVERIFY(bookWith({}).error.contains("cut off"));
        QVERIFY(bookWith({}).error.contains("frames 20 to 27"));
        const Outcome fit = run(QStringList{"fit"} + smoke);
        QCOMPARE(fit.code, 0);
        const QStringList options = QString::fromUtf8(fit.out.trimmed()).split(' ');
        QCOMPARE(options.size(), 4); // target and distance
        QVERIFY(!bookWith(options).error.contains("cut off"));
        QVERIFY(!bookWith({"--fit"}).error.contains("cut off"));
        QCOMPARE(run({"fit", "default", "--frames", "0", "--set", "look.opacity=0"}).code, 3);

        const Outcome nearer = run(QStringList{"fit"} + smoke + QStringList{"--ignore-outliers", "5"});
        QCOMPARE(nearer.code, 0);
        QVERIFY(nearer.out != fit.out);
        QCOMPARE(run(QStringList{"fit"} + smoke + QStringList{"--ignore-outliers", "0"}).out, fit.out);
        const Outcome cut = bookWith({"--fit", "--ignore-outliers", "5"});
        QVERIFY2(cut.code == 0 && !cut.error.contains("--fit moves"), cut.error);
        QCOMPARE(bookWith({"--fit", "--ignore-outliers", "6"}).code, 3);
        QCOMPARE(bookWith({"--ignore-outliers", "1"}).code, 2); // of what is not fitted
    }

    void outputsAreNamedAsTheUserMeans_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QStringList>("files");
        const auto row = [](const char* name, const QStringList& arguments, const QStringList& files) {
            QTest::newRow(name) << arguments << files;
        };
        const QStringList two{"render", "thesis-2012", "-f", "7-8", "-o"};
        const QStringList one{"render", "thesis-2012", "-f", "7", "-o"};
        row("capitals", one + QStringList{"x.PNG"}, {"x.PNG"});
        row("exr", one + QStringList{"x.Exr"}, {"x.Exr"});
        row("tga", one + QStringList{"x.TGA"}, {"x.TGA"});
        row("a flipbook in tga", {"flipbook", "thesis-2012", "--grid", "1", "-f", "7", "-o", "x", "--format", "tga"},
            {"x.flipbook.json", "x.tga"});
        row("noise in tga", {"bake-noise", "thesis-2012", "-o", "n.tga"}, {"n.tga"});
        row("format without an ending", one + QStringList{"x", "--format", "exr"}, {"x.exr"});
        row("printf", two + QStringList{"x_%03d.png"}, {"x_007.png", "x_008.png"});
        row("printf without width", two + QStringList{"x%d"}, {"x%d_0007.png", "x%d_0008.png"});
        row("hashes and no ending", two + QStringList{"x.##"}, {"x.07.png", "x.08.png"});
        row("a folder that is there", two + QStringList{"d"}, {"d/thesis-2012_0007.png", "d/thesis-2012_0008.png"});
        row("a folder to be made", one + QStringList{"e/"}, {"e/thesis-2012.png"});
        row("no name", {"render", "thesis-2012", "-f", "7"}, {"thesis-2012.png"});
        row("two presets", {"render", "thesis-2012", "default", "-f", "7", "-o", "d/"},
            {"d/default.png", "d/thesis-2012.png"});
        row("flipbook in a folder", {"flipbook", "thesis-2012", "--grid", "1", "-f", "7", "-o", "d"},
            {"d/thesis-2012.flipbook.json", "d/thesis-2012.png"});
        row("the best that fits",
            {"flipbook", "thesis-2012", "--for", "pixi", "-f", "0-9", "--optimise", "4KB", "-o", "d"},
            {"d/thesis-2012_4x2.atlas.json", "d/thesis-2012_4x2.flipbook.json", "d/thesis-2012_4x2.png"});
        row("trimmed and retimed",
            {"flipbook", "thesis-2012", "--grid", "2", "-f", "0-9", "--trim", "--retime", "[[0,1],[1,0]]", "-o", "x"},
            {"x.flipbook.json", "x.png"});
        row("packed pictures",
            {"flipbook", "--pack", "a=alpha", "thesis-2012", "--pack", "b=depth,1@1/2", "--passes", "none", "--grid",
                "1", "-f", "7", "-o", "x"},
            {"x.flipbook.json", "x_a.png", "x_b.png"});
        row("noise", {"bake-noise", "thesis-2012", "-o", "d"}, {"d/thesis-2012_noise.png"});
        row("particles by the ending", {"dump", "thesis-2012", "-o", "p.ply"}, {"p.ply"});
        row("point cache", {"dump", "thesis-2012", "-o", "p.pcache"}, {"p.pcache"});
        row("volumes", {"volume", "thesis-2012", "--cells", "16", "-f", "0-2:2", "-o", "v_##"},
            {"v_00.vdb", "v_02.vdb"});
        row("air", {"air", "plume", "--set", "air.resolution=16", "-o", "plume.vf"}, {"plume.vf"});
        row("air in its default format", {"air", "plume", "--set", "air.resolution=16", "-o", "."}, {"plume.fga"});
        row("particles of several frames", {"dump", "thesis-2012", "-f", "0-4:2", "-o", "p_##.csv"},
            {"p_00.csv", "p_02.csv", "p_04.csv"});
    }
    void outputsAreNamedAsTheUserMeans()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QStringList, files);
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkdir("d"));
        const bool isPicture = !QStringList{"dump", "volume", "air"}.contains(arguments[0]);
        const QString small = !isPicture
            ? " --set emitter.count=20"
            : " --size 16 --set emitter.count=20 --set noise.slices=1 --set noise.resolution=8";
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
        const RefusalRows row;
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
    void badNamesOfOutputsAreRefused() { isRefusedAsTheRowSays(); }

    void devicesAreNotGivenAnEnding()
    {
        const Outcome outcome = run({"render", "default", "-f", "0", "-o", "/dev/stdout"});
        QCOMPARE(outcome.code, 1);
        QVERIFY2(outcome.error.contains("- for standard output"), outcome.error.constData());
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
        // Nor where a file system ignores case.
        QVERIFY(QFile::rename(folder.filePath("b/mine.json"), folder.filePath("b/Mine.json")));
        const Outcome cases = runIn(folder, {"bake-noise", "a/mine.json", "b/Mine.json", "-o", "out/"});
        QCOMPARE(cases.code, 3);
        QVERIFY2(cases.error.contains("\"mine\" and \"Mine\" are the same"), cases.error.constData());
        QVERIFY(!QDir(folder.filePath("out")).exists());
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
        QCOMPARE(run(QStringList{"dump", "-", "--set", "emitter.count=50"}, piped).out,
            run({"dump", "campfire", "--set", "emitter.count=50"}).out);
        QCOMPARE(run({"validate", "-"}, "echo rubbish | \"$0\" \"$@\"").code, 3);
    }

    void aJoinNeverOverwritesAFrame()
    {
        const QTemporaryDir folder;
        QCOMPARE(runIn(folder, QStringList{"render", "default", "-f", "0-3", "-o", "a_##.exr"} + kSmall).code, 0);
        const QByteArray before = contents(folder.path());
        const Outcome outcome =
            runIn(folder, {"join", "a_00.exr", "-i", "a_##.exr", "-f", "0-3", "--grid", "2", "-o", "a_02.exr"});
        QVERIFY2(outcome.code == 3 && outcome.error.contains("one of the frames"), outcome.error.constData());
        QVERIFY(contents(folder.path()) == before);
    }

    void aLackOfThreadsOrFilesIsToBeTriedAgain()
    {
        const QTemporaryDir folder;
        QVERIFY(QFile(folder.path()).setPermissions(QFileDevice::Permissions(0x7777)));
        const QStringList arguments =
            QStringList{"render", "default", "-f", "0-3", "-o", folder.filePath("a_##.png")} + kSmall;
        const QString asNobody = geteuid() == 0 ? "setpriv --reuid=65533 --clear-groups " : "";
        // A sanitizer would look for leaks in a thread of its own.
        const Outcome threads = run(arguments,
            "cd / && export ASAN_OPTIONS=detect_leaks=0 && " + asNobody
                + "bash -c 'ulimit -u 1; exec \"$0\" \"$@\"' \"$0\" \"$@\"");
        QVERIFY2(threads.code == 75 && threads.error.contains("threads") && threads.error.contains("ulimit"),
            threads.error.constData());
#ifndef FUMAGE_SANITIZED // UndefinedBehaviorSanitizer opens a pipe to look at the type of an object
        const Outcome files =
            run(arguments, "exec 3>&-; ulimit -n 4; \"$0\" \"$@\""); // what it was given by others is closed
        QVERIFY2(files.code == 75 && files.error.contains("ulimit"), files.error.constData());
#endif
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void namesThatAreTooLongAreNotTriedAgain()
    {
        const QTemporaryDir folder;
        const QString name(300, 'x');
        for (const QStringList& arguments : {QStringList{"render", name + ".json"},
                 QStringList{"render", "default", "-f", "0", "-o", name + ".png"} + kSmall, QStringList{"verify", name},
                 QStringList{"validate", name + ".json"},
                 QStringList{"dump", "default", "--set", "emitter.count=5", "-o", name + ".csv"},
                 QStringList{"render", "--jobs", name}, QStringList{"presets", "--show", "default", "-o", name},
                 QStringList{"flipbook", "default", "--grid", "1", "-f", "0", "-o", name + ".png"} + kSmall}) {
            const Outcome outcome = runIn(folder, arguments);
            QVERIFY2(outcome.code == 1 && outcome.error.contains("too long"), outcome.error.constData());
        }
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
        row("a preset as JSON", {"presets", "--show", "my.json", "-o", "my.json"});
        row("a preset as JSON through a link", {"presets", "--show", "my.csv", "-o", "link.csv"});
        row("join to a sheet", {"join", "my.png", "-i", "x_##.exr", "-f", "0-3", "--grid", "2", "-o", "my.png"});
        row("join to a video", {"join", "my.mp4", "-i", "x_##.exr", "-f", "0-3", "-o", "my.mp4"});
        row("video", {"video", "my.gif", "-f", "0", "-o", "my.gif"});
        row("volume", {"volume", "my.vdb", "-o", "my.vdb"});
        row("air", {"air", "my.fga", "--set", "air.enabled=true", "-o", "my.fga"});
        row("farm", {"farm", "my.fumage.json", "--for", "slurm", "-o", "my_##.exr"});
        row("flipbook's description", {"flipbook", "my.flipbook.json", "--grid", "1", "-f", "0", "-o", "my"});
    }
    void aCommandNeverOverwritesItsPreset()
    {
        QFETCH(QStringList, arguments);
        const QTemporaryDir folder;
        const QString preset = folder.filePath(arguments[1].startsWith('-') ? arguments[2] : arguments[1]);
        QVERIFY(writePresetFile(preset.toStdString(), Preset()).ok());
        QVERIFY(QFile::link(preset, folder.filePath("link.csv")));
        const QByteArray before = contents(folder.path());
        const Outcome outcome = runIn(folder, arguments);
        QCOMPARE(outcome.code, 3);
        QVERIFY2(outcome.error.contains("overwrite the preset"), outcome.error.constData());
        QVERIFY(contents(folder.path()) == before);
    }
};

QTEST_GUILESS_MAIN(CliOutputTest)
#include "cli_output_test.moc"
