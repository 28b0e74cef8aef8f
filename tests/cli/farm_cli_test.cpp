// Frames that many machines share: manifests, what is there already, what schedulers are told, and what farms are
// given.

#include "tests/cli/refusals.h"
#include "tests/helpers.h"

#include "core/preset/preset_file.h"
#include "core/system/file.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

using namespace fumage;
using namespace fumage::tests;

namespace {

QStringList renderOf(const QString& frames, const QStringList& more = {})
{
    return QStringList{"render", "thesis-2012", "-f", frames, "-o", "f_##.png"} + kSmall + more;
}

} // namespace

class FarmCliTest : public QObject {
    Q_OBJECT

private slots:
    void verifySaysWhatIsNotAsItShouldBe()
    {
        const QTemporaryDir folder;
        QCOMPARE(runIn(folder, renderOf("0-3", {"--manifest"})).code, 0);
        QCOMPARE(runIn(folder, renderOf("4-5", {"--manifest"})).code, 0);
        const Outcome clean = runIn(folder, {"verify", ".", "--frames", "0-5"});
        QVERIFY2(clean.code == 0 && clean.out.contains("6 of 6"), clean.error);
        QVERIFY(QFile::remove(folder.filePath("f_02.png")));
        const Outcome torn = runIn(folder, {"verify", "."});
        QCOMPARE(torn.code, 4);
        QVERIFY2(torn.out.contains("missing: f_02.png"), torn.out);
        QVERIFY2(torn.error.contains("--skip-existing"), torn.error);
        const Outcome json = runIn(folder, {"verify", ".", "--frames", "0-7", "--json"});
        QCOMPARE(json.code, 4);
        const QJsonObject answer = QJsonDocument::fromJson(json.out).object();
        QCOMPARE(answer["clean"].toBool(), false);
        QCOMPARE(answer["same"].toInt(), 5);
        QCOMPARE(answer["missing"].toArray(), (QJsonArray{"f_02.png", 6, 7}));
        QCOMPARE(runIn(folder, {"verify", "f.4-5.manifest.json"}).code, 0);
    }

    void verifyRendersAgain()
    {
        const QTemporaryDir folder;
        QCOMPARE(runIn(folder, renderOf("0-3", {"--manifest=all.json", "--format", "png16"})).code, 0);
        const Outcome again = runIn(folder, {"verify", "all.0-3.manifest.json", "--render", "1-2"});
        QVERIFY2(again.code == 0 && again.out.contains("2 of 2"), again.error);
        QCOMPARE(runIn(folder, {"verify", ".", "--render", "9"}).code, 3);
        QCOMPARE(runIn(folder, {"verify", ".", "--render", "1", "--frames", "1"}).code, 2);
    }

    void verifySaysWhatCannotBeRenderedAgain()
    {
        const QTemporaryDir folder;
        QCOMPARE(
            runIn(folder, QStringList{"dump", "thesis-2012", "-f", "2", "-o", "p.csv", "--manifest"} + kSmall.mid(2))
                .code,
            0);
        QCOMPARE(runIn(folder, {"verify", "."}).code, 0);
        const Outcome particles = runIn(folder, {"verify", ".", "--render", "1-2"});
        QVERIFY2(particles.code == 3 && particles.error.contains("cannot be rendered again"), particles.error);
        const Outcome others = runIn(folder, {"verify", ".", "--render", "3-4"});
        QVERIFY2(others.code == 3 && others.error.contains("name none of the frames 3 to 4"), others.error);
        QCOMPARE(runIn(folder, renderOf("0-1", {"--manifest"})).code, 0);
        const Outcome both = runIn(folder, {"verify", ".", "--render", "0-2"});
        QVERIFY2(both.code == 0 && both.out.contains("2 of 2"), both.error);
    }

    void verifyWithoutAManifestSaysHowToWriteOne()
    {
        const QTemporaryDir folder;
        const Outcome none = runIn(folder, {"verify", "."});
        QVERIFY2(none.code == 1 && none.error.contains("--manifest"), none.error);
        QVERIFY(
            writeFileAtomically(folder.filePath("x.manifest.json").toStdString(), std::string_view("{\"format\": 1}"))
                .ok());
        const Outcome wrong = runIn(folder, {"verify", "."});
        QVERIFY2(wrong.code == 3 && wrong.error.contains("x.manifest.json"), wrong.error);
    }

    void aFlipbookHasAManifestOfAllItsFiles()
    {
        const QTemporaryDir folder;
        QCOMPARE(runIn(folder,
                     QStringList{"flipbook", "thesis-2012", "--grid", "2x2", "-f", "0-7", "--for", "unity",
                         "--manifest", "-o", "sheet.png"}
                         + kSmall)
                     .code,
            0);
        QCOMPARE(runIn(folder, {"verify", "."}).code, 0);
        const Outcome again = runIn(folder, {"verify", ".", "--render", "0"});
        QVERIFY2(again.code == 0 && again.out.contains("files come out the same"), again.error);
        QFile side(folder.filePath("sheet.flipbook.json"));
        QVERIFY(side.open(QIODevice::Append) && side.write(" ") == 1);
        side.close();
        const Outcome changed = runIn(folder, {"verify", "."});
        QVERIFY2(changed.code == 4 && changed.out.contains("different: sheet.flipbook.json"), changed.out);
    }

    void filesThatAreNoPicturesHaveManifestsToo_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("particles") << QStringList{"dump", "thesis-2012", "--set", "emitter.count=50", "-o", "p_##.ply"};
        QTest::newRow("volumes") << QStringList{
            "volume", "thesis-2012", "--set", "emitter.count=50", "--cells", "16", "-o", "v_##.vdb"};
        QTest::newRow("air") << QStringList{"air", "plume", "--set", "air.resolution=8", "-o", "a_##.fga"};
    }
    void filesThatAreNoPicturesHaveManifestsToo()
    {
        QFETCH(QStringList, arguments);
        const QTemporaryDir folder;
        QCOMPARE(runIn(folder, arguments + QStringList{"--frames", "0-1", "--manifest"}).code, 0);
        QCOMPARE(runIn(folder, arguments + QStringList{"--frames", "2-2", "--manifest"}).code, 0);
        const Outcome clean = runIn(folder, {"verify", ".", "--frames", "0-2"});
        QVERIFY2(clean.code == 0 && clean.out.contains("3 of 3"), clean.out + clean.error);
        const QString ending = arguments.back().right(4);
        QFile file(folder.filePath(arguments.back().left(2) + "01" + ending));
        QVERIFY(file.open(QIODevice::Append) && file.write(" ") == 1);
        file.close();
        QVERIFY(runIn(folder, {"verify", "."}).out.contains("different: " + arguments.back().left(2).toUtf8() + "01"));
        QCOMPARE(runIn(folder, {"verify", ".", "--render", "0"}).code, 3); // only pictures are rendered again
    }

    void whatIsThereIsNotRenderedAgain()
    {
        const QTemporaryDir folder;
        QCOMPARE(runIn(folder, renderOf("0-5")).code, 0);
        const QByteArray before = contents(folder.path());
        QFile half(folder.filePath("f_03.png"));
        QVERIFY(half.resize(half.size() - 1));
        const Outcome again = runIn(folder, renderOf("0-5", {"--skip-existing"}));
        QCOMPARE(again.code, 0);
        QVERIFY2(again.error.contains("5 of 6 files were there already"), again.error);
        QCOMPARE(contents(folder.path()), before);
        const Outcome none = runIn(folder, renderOf("0-5", {"--skip-existing"}));
        QVERIFY2(none.code == 0 && none.error.contains("6 of 6 files were there already"), none.error);
    }

    void openJobDescriptionHearsOfProgressAndFailure()
    {
        const QTemporaryDir folder;
        const Outcome done = runIn(folder, renderOf("0-3", {"--progress", "openjd"}));
        QCOMPARE(done.code, 0);
        QVERIFY2(done.out.contains("openjd_status: Rendering\n"), done.out);
        QList<int> told;
        for (const QByteArray& line : done.out.split('\n')) {
            if (line.startsWith("openjd_progress: ")) {
                told.push_back(line.mid(17).toInt());
            }
        }
        QCOMPARE(told, (QList<int>{25, 50, 75, 100}));
        const Outcome failed = runIn(folder, {"--progress", "openjd", "render", "thesis-2012", "-f", "9-2"});
        QVERIFY2(failed.code == 3 && failed.out.startsWith("openjd_fail: frames \"9-2\""), failed.out);
        QCOMPARE(runIn(folder, {"--progress", "openjd", "render", "thesis-2012", "-f", "0", "-o", "-"}).code, 3);
    }

    void aSheetAndAVideoAreJoinedOfFrames()
    {
        const QTemporaryDir folder;
        QCOMPARE(runIn(folder, renderOf("0-7", {"--format", "exr"})).code, 3); // the name says PNG
        const QStringList exr{"render", "thesis-2012", "-f", "0-7", "-o", "f_##.exr"};
        QCOMPARE(runIn(folder, exr + kSmall).code, 0);
        const QStringList small = kSmall.mid(2) + QStringList{"--set", "output.width=48", "--set", "output.height=48"};
        const Outcome sheet = runIn(folder,
            QStringList{"join", "thesis-2012", "--input", "f_##.exr", "-f", "0-7", "--grid", "2x2", "-o", "sheet.png"}
                + small);
        QVERIFY2(sheet.code == 0, sheet.error);
        QVERIFY(QFile::exists(folder.filePath("sheet.flipbook.json")));
        const Outcome wrong = runIn(
            folder, {"join", "thesis-2012", "--input", "f_##.exr", "-f", "0-7", "--grid", "2x2", "-o", "other.png"});
        QVERIFY2(wrong.code == 3 && wrong.error.contains("f_00.exr"), wrong.error);
    }

    void aFarmGetsItsFilesAndThePresetAsItIs_data()
    {
        QTest::addColumn<QString>("farm");
        QTest::addColumn<QStringList>("files");
        QTest::newRow("slurm") << "slurm" << QStringList{"smoke.fumage.json", "smoke.join.slurm.sh", "smoke.slurm.sh"};
        QTest::newRow("openjd") << "openjd" << QStringList{"smoke.fumage.json", "smoke.openjd.json"};
        QTest::newRow("flamenco") << "flamenco" << QStringList{"smoke.flamenco.js", "smoke.fumage.json"};
        QTest::newRow("deadline") << "deadline"
                                  << QStringList{"smoke.deadline.job", "smoke.deadline.plugin", "smoke.deadline.sh",
                                         "smoke.fumage.json", "smoke.join.deadline.job", "smoke.join.deadline.plugin"};
    }
    void aFarmGetsItsFilesAndThePresetAsItIs()
    {
        QFETCH(QString, farm);
        QFETCH(QStringList, files);
        const QTemporaryDir folder;
        const Outcome made = runIn(folder,
            QStringList{"farm", "thesis-2012", "-f", "0-63", "--for", farm, "--then", "flipbook", "--chunk", "8", "-o",
                "out/smoke_####"}
                + kSmall);
        QVERIFY2(made.code == 0, made.error);
        QVERIFY2(made.error.contains("64 frames in 8 tasks of 8"), made.error);
        QVERIFY(!made.out.isEmpty());
        QCOMPARE(QDir(folder.filePath("out")).entryList(QDir::Files, QDir::Name), files);
        const Outcome preset = runIn(folder, {"presets", "--show", "out/smoke.fumage.json"});
        QVERIFY2(preset.out.contains("\"width\": 48") && preset.out.contains("\"count\": 500"), preset.out);
    }

    void farmsRefuseWhatCannotWork_data()
    {
        const RefusalRows row({"farm", "thesis-2012", "--for", "slurm"});
        row("standard output", {"-o", "-"}, "standard output");
        row("joined PNG", {"--then", "video", "-o", "a_##.png"}, "--format exr");
        row("too few frames", {"--then", "flipbook", "-f", "0-9"}, "64 cells");
        row("frames", {"-f", "9-2"}, "9-2");
        row("chunk", {"--chunk", "0"}, "chunk");
        row("pass", {"--passes", "sixway"}, "six-way");
        row("passes that PNG does not hold", {"--passes", "depth", "-o", "a_##.png"}, "Choose EXR");
        row("masks that PNG does not hold", {"--passes", "layer-masks", "-o", "a_##.png"}, "Choose EXR");
        row("a sheet that cannot be joined", {"--then", "flipbook", "-f", "0-63", "--size", "8192"}, "fewer cells");
    }
    void farmsRefuseWhatCannotWork() { isRefusedAsTheRowSays(); }

    void openJobDescriptionGetsNoLongerTasksThanItTakes()
    {
        const QTemporaryDir folder;
        const QStringList words{"farm", "thesis-2012", "--for", "openjd", "-f", "0-9999", "--set", "output.width=4",
            "--set", "output.height=4", "-o", "a_##.png"};
        const Outcome refused = runIn(folder, words + QStringList{"--chunk", "151"});
        QVERIFY2(refused.code == 3 && refused.error.contains("150"), refused.error);
        QVERIFY(!QFile::exists(folder.filePath("a.openjd.json")));
        const Outcome chosen = runIn(folder, words);
        QVERIFY2(chosen.code == 0, chosen.error);
        const int perTask = chosen.error.trimmed().split(' ').last().toInt();
        QVERIFY2(perTask >= 1 && perTask <= 150, chosen.error);
    }

    /// Both would be the job "fire": what stands for the number is no part of its name.
    void farmsKeepTheJobsOfPresetsApart()
    {
        const QTemporaryDir folder;
        for (const char* name : {"/fire.json", "/fire_##.json"}) {
            QVERIFY(writePresetFile(folder.path().toStdString() + name, Preset()).ok());
        }
        const Outcome made =
            runIn(folder, {"farm", "fire.json", "fire_##.json", "-f", "0-3", "--for", "slurm", "-o", "out/"});
        QCOMPARE(made.code, 3);
        QVERIFY2(made.error.contains("\"fire_##\" would write over a file of \"fire\""), made.error);
        QCOMPARE(QDir(folder.filePath("out")).entryList(QDir::Files, QDir::Name),
            (QStringList{"fire.fumage.json", "fire.slurm.sh"}));
    }

    void aFarmNeverOverwritesThePresetThatItIsMadeOf()
    {
        const QTemporaryDir folder;
        QCOMPARE(runIn(folder, {"farm", "thesis-2012", "--for", "slurm", "-o", "a_##.png"}).code, 0);
        const QByteArray before = contents(folder.path());
        QCOMPARE(runIn(folder, {"farm", "a.fumage.json", "--for", "slurm", "-o", "a_##.png"}).code, 3);
        QCOMPARE(contents(folder.path()), before);
    }
};

QTEST_GUILESS_MAIN(FarmCliTest)
#include "farm_cli_test.moc"
