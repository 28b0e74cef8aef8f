// Lists of jobs, done by the command line.

#include "tests/cli/run.h"
#include "tests/helpers.h"

#include "core/system/file.h"
#include "core/preset/preset_file.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// A file with jobs: $small and $large stand for presets of little smoke, and the size of its picture.
QString writeList(const QTemporaryDir& folder, QString jobs)
{
    Preset preset;
    preset.scene.layers[0].emitter.count = 300;
    preset.scene.layers[0].noise.slices = 4;
    preset.scene.layers[0].noise.resolution = 16;
    for (const auto& [word, edge] : {std::pair{"$small", 32}, std::pair{"$large", 400}}) {
        preset.scene.output.width = preset.scene.output.height = edge;
        jobs.replace(word, "\"preset\": " + QString::fromStdString(formatPreset(preset)));
    }
    const QString file = folder.filePath("list.json");
    const std::string text = R"({"format": "fumage-jobs", "version": 1, "jobs": [)" + jobs.toStdString() + "]}";
    return writeFileAtomically(file.toStdString(), text).ok() ? file : QString();
}

} // namespace

class CliJobsTest : public QObject {
    Q_OBJECT

private slots:
    void aListOfJobsGoesOnAfterOneThatFails()
    {
        const QTemporaryDir folder;
        QVERIFY(writePresetFile(folder.filePath("mine.json").toStdString(), Preset()).ok());
        const QString list = writeList(folder,
            R"({"name": "good", "output": "a/x_##.png", "frames": "0-1", $small},)"
            R"({"name": "nowhere", "output": "/proc/nowhere/b.png", "kind": "picture", $small},)"
            R"({"name": "large", "output": "large.exr", "kind": "picture", $large},)"
            R"({"name": "itself", "output": "c.png", "kind": "picture", "source": "c.png", $small},)"
            R"({"name": "book", "output": "d.png", "kind": "flipbook", )"
            R"("columns": 2, "rows": 1, "frames": "0-3", $small})");
        QVERIFY(QFile::copy(folder.filePath("mine.json"), folder.filePath("c.png")));
        // A limit on the size of files fails as a full disk does.
        QVERIFY(list == folder.filePath("list.json"));
        const Outcome outcome = run({"render", "--jobs", "list.json", "--json"},
            "cd '" + folder.path() + "' && trap '' XFSZ; ulimit -f 60; \"$0\" \"$@\"");
        QCOMPARE(outcome.code, 1);
        QVERIFY2(outcome.error.contains("job 3 of 5: large\n"), outcome.error.constData());
        QVERIFY2(outcome.error.contains("fumage-cli: nowhere: ") && outcome.error.contains("fumage-cli: large: ")
                && outcome.error.contains("fumage-cli: itself: c.png: this would overwrite"),
            outcome.error.constData());
        QVERIFY2(outcome.error.trimmed().endsWith(": 3 of 5 jobs failed. Mend what is said above, and do them again"),
            outcome.error.constData());
        QCOMPARE(QDir(folder.filePath("a")).entryList(QDir::Files), (QStringList{"x_00.png", "x_01.png"}));
        QVERIFY(QFile::exists(folder.filePath("d.flipbook.json")) && !QFile::exists(folder.filePath("large.exr")));
        const QJsonObject answer = QJsonDocument::fromJson(outcome.out).object();
        QCOMPARE(answer["done"].toInt(), 2);
        QCOMPARE(answer["failed"].toInt(), 3);
        const QJsonArray jobs = answer["jobs"].toArray();
        QCOMPARE(jobs.size(), 5);
        QCOMPARE(jobs[0].toObject()["outcome"].toString(), QString("done"));
        QCOMPARE(jobs[0].toObject()["files"].toInt(), 2);
        QCOMPARE(jobs[0].toObject()["last"].toString(), QString("a/x_01.png"));
        QCOMPARE(jobs[1].toObject()["outcome"].toString(), QString("failed"));
        QVERIFY(jobs[2].toObject()["error"].toString().contains("large.exr"));
        QCOMPARE(jobs[4].toObject()["last"].toString(), QString("d.flipbook.json"));
        // All of them done is a success, and standard input will do.
        const Outcome fine = run({"render", "--jobs", "-"},
            "cd '" + folder.path() + "' && \"$0\" \"$@\" < "
                + writeList(folder, R"({"output": "e.png", "kind": "picture", $small})"));
        QVERIFY2(fine.code == 0 && fine.error.trimmed().endsWith("wrote e.png"), fine.error.constData());
    }

    void aListIsDoneFromAnyFolder()
    {
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath("deep"));
        Preset preset;
        preset.scene.layers[0].emitter.count = 300;
        preset.scene.output.width = preset.scene.output.height = 32;
        QVERIFY(writePresetFile(folder.filePath("deep/my.json").toStdString(), preset).ok());
        const std::string list = R"({"format": "fumage-jobs", "version": 1, "jobs": [{"name": "A", )"
                                 R"("preset": "missing.json", "kind": "picture", "output": "a.png"},
            {"name": "B", "preset": "my.json", "kind": "picture", "frames": "5", "output": "out/b.png"},
            {"name": "C", "preset": "my.json", "frames": "5-6", "output": "jj_%04d.png"}]})";
        QVERIFY(writeFileAtomically(folder.filePath("deep/jobs.json").toStdString(), list).ok());
        const Outcome outcome = runIn(folder, {"render", "--jobs", "deep/jobs.json", "--json"});
        QCOMPARE(outcome.code, 1); // as of a preset that is not there
        QVERIFY2(outcome.error.contains("fumage-cli: A: deep/missing.json: cannot read"), outcome.error.constData());
        QVERIFY(QFile::exists(folder.filePath("deep/out/b.png")) && QFile::exists(folder.filePath("deep/jj_0005.png"))
            && QFile::exists(folder.filePath("deep/jj_0006.png")));
        QCOMPARE(QDir(folder.path()).entryList(QDir::NoDotAndDotDot | QDir::AllEntries), QStringList{"deep"});
        const QJsonArray jobs = QJsonDocument::fromJson(outcome.out).object()["jobs"].toArray();
        QCOMPARE(jobs[0].toObject()["outcome"].toString(), QString("failed"));
        QCOMPARE(jobs[1].toObject()["first"].toString(), QString("deep/out/b.png"));
    }

    void jobsKeepTheirManifestAndWhatIsThere()
    {
        const QTemporaryDir folder;
        const QString list = writeList(
            folder, R"({"output": "x.png", "frames": "0-2", "manifest": "x", "skip_existing": true, $small})");
        const Outcome first = runIn(folder, {"render", "--jobs", list});
        QVERIFY2(first.code == 0 && first.error.contains("wrote 3 files"), first.error.constData());
        QVERIFY(QFile::remove(folder.filePath("x_0001.png")));
        QCOMPARE(runIn(folder, {"verify", "x.0-2.manifest.json"}).code, 4);
        const Outcome second = runIn(folder, {"render", "--jobs", list});
        QVERIFY2(
            second.code == 0 && second.error.contains("2 of 3 files were there already"), second.error.constData());
        QCOMPARE(runIn(folder, {"verify", "x.0-2.manifest.json"}).code, 0);
    }

    void jobsOfOneFileAreRefusedBeforeAnythingIsRendered()
    {
        const QTemporaryDir folder;
        const QString list = writeList(folder,
            R"({"name": "one", "output": "a.png", "kind": "picture", $small}, )"
            R"({"name": "two", "output": "./a.png", "kind": "flipbook", "columns": 1, "rows": 1, $small})");
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
};

QTEST_GUILESS_MAIN(CliJobsTest)
#include "cli_jobs_test.moc"
