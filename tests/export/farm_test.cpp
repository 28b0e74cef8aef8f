// How frames are divided among machines, and what farms are given.
#include "tests/helpers.h"

#include "core/export/farm/chunk.h"
#include "core/export/farm/farm.h"
#include "core/preset/library.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// A cost of which only the air counts: frame f is reached after 10 f s, and takes 5 s.
FarmCost airAlone()
{
    FarmCost cost;
    cost.frame = 5.0;
    cost.airStep = 10.0;
    return cost;
}

double reached(const FarmCost& cost, const FrameRange& frames, int perTask)
{
    double sum = 0.0;
    for (int task = 0; task < taskCount(frames, perTask); ++task) {
        sum += cost.reach(framesOfTask(frames, perTask, task).first);
    }
    return sum;
}

FarmJob someJob()
{
    FarmJob job;
    job.folder = "/mnt/a b/it's \"é\" $HOME";
    job.name = "-rök 烟";
    job.output = "-rök 烟_####.exr";
    job.frames = {10, 31, 2};
    job.perTask = 4;
    job.renderWords = {"--format", "exr"};
    job.joinWords = {"join", "./-rök 烟.fumage.json", "--output", "./-rök 烟.mp4"};
    return job;
}

const FarmFile& fileThatEnds(const FarmFiles& files, std::string_view ending)
{
    for (const FarmFile& file : files.files) {
        if (file.path.string().ends_with(ending)) {
            return file;
        }
    }
    qFatal("no file %s", std::string(ending).c_str());
}

} // namespace

class FarmTest : public QObject {
    Q_OBJECT

private slots:
    void tasksHaveEachFrameOnce_data()
    {
        QTest::addColumn<int>("perTask");
        for (const int perTask : {1, 2, 3, 7, 10, 11, 12, 100}) {
            QTest::newRow(std::to_string(perTask).c_str()) << perTask;
        }
    }
    void tasksHaveEachFrameOnce()
    {
        QFETCH(int, perTask);
        const FrameRange frames{10, 31, 2};
        std::vector<int> all;
        for (int task = 0; task < taskCount(frames, perTask); ++task) {
            const FrameRange part = framesOfTask(frames, perTask, task);
            QVERIFY(part.count() <= perTask);
            for (int i = 0; i < part.count(); ++i) {
                all.push_back(part.at(i));
            }
        }
        QCOMPARE(all.size(), static_cast<std::size_t>(frames.count()));
        for (int i = 0; i < frames.count(); ++i) {
            QCOMPARE(all[static_cast<std::size_t>(i)], frames.at(i));
        }
    }

    void theWayToFramesTakesNoMoreThanTheFrames()
    {
        const FarmCost cost = airAlone();
        const FrameRange frames{0, 119, 1};
        const int perTask = framesPerTask(cost, frames);
        // n tasks begin at 0, 120/n, ...: their ways take 600 (n - 1) s, the frames 600 s.
        QCOMPARE(taskCount(frames, perTask), 2);
        QVERIFY(reached(cost, frames, perTask) <= 600.0);
        QVERIFY(reached(cost, frames, perTask - 1) > 600.0);
    }

    void whatCostsNothingToReachIsOneFrameATask()
    {
        FarmCost cost;
        cost.frame = 1.0;
        QCOMPARE(framesPerTask(cost, {0, 119, 1}), 1);
        QCOMPARE(framesPerTask(cost, {7, 7, 1}), 1);
        QVERIFY(taskCount({0, 99'999, 1}, framesPerTask(cost, {0, 99'999, 1})) <= kMaxTasks);
    }

    void tasksThatFarmsTakeLongToStartAreLonger()
    {
        FarmCost cost;
        cost.frame = 0.1;
        cost.start = 1.0;
        QCOMPARE(framesPerTask(cost, {0, 119, 1}), 10); // 12 tasks take 12 s to start, and 120 frames 12 s
    }

    void aWayThatIsTooLongIsGoneOnce()
    {
        FarmCost cost = airAlone();
        cost.firstStep = 1000; // even the first task takes longer to get there than all frames
        QCOMPARE(framesPerTask(cost, {0, 119, 1}), 120);
    }

    void particlesAreNoFartherBackThanTheyLive()
    {
        FarmCost cost;
        cost.particleStep = 2.0;
        cost.lifetimeSteps = 10;
        QCOMPARE(cost.reach(4), 8.0);
        QCOMPARE(cost.reach(400), 20.0);
        cost.airStep = 1.0;
        QCOMPARE(cost.reach(400), 420.0);
    }

    void airCostsMoreWithFinerCells()
    {
        Effect effect = loadPreset("plume").value().preset.scene.effect();
        effect.air.resolution = 32;
        const double coarse = farmCost(effect).airStep;
        effect.air.resolution = 64;
        const double fine = farmCost(effect).airStep;
        QVERIFY(coarse > 0.0);
        QVERIFY2(fine > 6.0 * coarse && fine < 10.0 * coarse,
            std::to_string(fine / coarse).c_str()); // eight times as many cells, but for rounding
        effect.air.enabled = false;
        QCOMPARE(farmCost(effect).airStep, 0.0);
    }

    void farmsThatReadJsonGetJson()
    {
        const FarmFiles files = makeFarmFiles(Farm::OpenJd, someJob()).value();
        QJsonParseError error;
        const QJsonObject root =
            QJsonDocument::fromJson(QByteArray::fromStdString(files.files.at(0).contents), &error).object();
        QVERIFY2(error.error == QJsonParseError::NoError, qPrintable(error.errorString()));
        QCOMPARE(root["specificationVersion"].toString(), QString("jobtemplate-2023-09"));
        const QJsonArray steps = root["steps"].toArray();
        QCOMPARE(steps.size(), 2);
        const QJsonObject action = steps[0]["script"]["actions"]["onRun"].toObject();
        QCOMPARE(action["command"].toString(), QString("{{Param.Program}}"));
        QVERIFY(action["args"].toArray().contains(QString::fromUtf8("{{Param.Folder}}/-rök 烟_####.exr")));
        QCOMPARE(steps[0]["parameterSpace"]["taskParameterDefinitions"][0]["chunks"]["rangeConstraint"].toString(),
            QString("NONCONTIGUOUS"));
        QCOMPARE(steps[1]["dependencies"][0]["dependsOn"].toString(), QString("Render"));
    }

    void shellsTakeNamesAsTheyAre()
    {
        const FarmFiles files = makeFarmFiles(Farm::Slurm, someJob()).value();
        QCOMPARE(files.files.size(), std::size_t{2});
        for (const FarmFile& file : files.files) {
            QProcess shell;
            // In place of the program one that prints its words; the folder is not there.
            const QString script = QString::fromStdString(file.contents).replace("cd '", "echo '");
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.insert("FUMAGE_CLI", "/bin/echo");
            environment.insert("SLURM_ARRAY_TASK_ID", "2");
            shell.setProcessEnvironment(environment);
            shell.start("bash", {"-c", script});
            QVERIFY(shell.waitForFinished());
            const QString out = QString::fromUtf8(shell.readAllStandardOutput());
            QCOMPARE(out.section('\n', 0, 0), QString::fromUtf8("/mnt/a b/it's \"é\" $HOME"));
            const bool isJoin = file.path.string().ends_with("join.slurm.sh");
            QVERIFY2(
                out.contains(QString::fromUtf8(isJoin ? "--output ./-rök 烟.mp4"
                                                      : "render ./-rök 烟.fumage.json --frames 26-30:2 --output ./-rök "
                                                        "烟_####.exr --skip-existing --manifest --format exr")),
                qPrintable(out));
        }
    }

    void slurmTriesAgainWhatMayWorkAnotherTime_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("dies");
        QTest::addColumn<int>("restarts");
        QTest::addColumn<int>("code");
        QTest::addColumn<bool>("isTriedAgain");
        for (const char* file : {"烟.slurm.sh", "join.slurm.sh"}) {
            const auto row = [&](const char* name, const char* dies, int restarts, int code, bool isTriedAgain) {
                QTest::newRow(qPrintable(QString("%1 %2").arg(QString::fromUtf8(file), name)))
                    << QString::fromUtf8(file) << dies << restarts << code << isTriedAgain;
            };
            row("killed", "kill -9 $$", 0, 137, true);
            row("killed, the third time", "kill -9 $$", 2, 137, true);
            row("killed, too often", "kill -9 $$", 3, 137, false);
            row("no memory", "exit 75", 0, 75, true);
            row("interrupted", "exit 130", 0, 130, true);
            row("wrong", "exit 3", 0, 3, false);
            row("done", "exit 0", 0, 0, false);
        }
    }
    void slurmTriesAgainWhatMayWorkAnotherTime()
    {
        QFETCH(QString, file);
        QFETCH(QString, dies);
        QFETCH(int, restarts);
        const QTemporaryDir folder;
        const auto program = [&](const QString& name, const QString& does) {
            QFile script(folder.filePath(name));
            QVERIFY(script.open(QIODevice::WriteOnly));
            script.write(("#!/bin/bash\n" + does + "\n").toUtf8());
            script.setPermissions(QFile::ReadOwner | QFile::ExeOwner);
        };
        program("dies", dies);
        program("scontrol", "echo \"$@\" > '" + folder.filePath("said") + "'");
        FarmJob job = someJob();
        job.folder = folder.path().toStdString();
        const FarmFile script = fileThatEnds(makeFarmFiles(Farm::Slurm, job).value(), file.toStdString());
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("PATH", folder.path() + ":" + environment.value("PATH"));
        environment.insert("FUMAGE_CLI", folder.filePath("dies"));
        environment.insert("SLURM_ARRAY_TASK_ID", "2");
        environment.insert("SLURM_ARRAY_JOB_ID", "7");
        environment.insert("SLURM_JOB_ID", "8");
        environment.insert("SLURM_RESTART_COUNT", QString::number(restarts));
        QProcess shell;
        shell.setProcessEnvironment(environment);
        shell.start("bash", {"-c", QString::fromStdString(script.contents)});
        QVERIFY(shell.waitForFinished());
        QTEST(shell.exitCode(), "code");
        QFile said(folder.filePath("said"));
        QTEST(said.exists(), "isTriedAgain");
        if (said.open(QIODevice::ReadOnly)) {
            QCOMPARE(said.readAll().trimmed(), QByteArray(file == "join.slurm.sh" ? "requeue 8" : "requeue 7_2"));
        }
    }

    void slurmTasksTakeTheCoresThatTheyWereGiven_data()
    {
        QTest::addColumn<QString>("aTask");
        QTest::addColumn<QString>("onNode");
        QTest::addColumn<QString>("threads");
        QTest::newRow("asked for") << "4"
                                   << "16"
                                   << "4";
        QTest::newRow("not asked for") << ""
                                       << "1"
                                       << "1";
        QTest::newRow("Slurm says nothing") << ""
                                            << ""
                                            << "0";
    }
    void slurmTasksTakeTheCoresThatTheyWereGiven()
    {
        QFETCH(QString, aTask);
        QFETCH(QString, onNode);
        QFETCH(QString, threads);
        FarmJob job = someJob();
        job.folder = "/";
        const FarmFiles files = makeFarmFiles(Farm::Slurm, job).value();
        for (const FarmFile& file : files.files) {
            QProcessEnvironment environment;
            environment.insert("PATH", "/usr/bin:/bin");
            environment.insert("FUMAGE_CLI", "/bin/echo");
            environment.insert("SLURM_ARRAY_TASK_ID", "2");
            if (!aTask.isEmpty()) {
                environment.insert("SLURM_CPUS_PER_TASK", aTask);
            }
            if (!onNode.isEmpty()) {
                environment.insert("SLURM_CPUS_ON_NODE", onNode);
            }
            QProcess shell;
            shell.setProcessEnvironment(environment);
            shell.start("bash", {"-c", QString::fromStdString(file.contents)});
            QVERIFY(shell.waitForFinished());
            const QByteArray out = shell.readAllStandardOutput();
            QVERIFY2(out.startsWith(("--threads " + threads + ' ').toUtf8()), out);
        }
    }

    void joiningDoesNotWaitForTasksThatFailed()
    {
        // A task that failed for good would keep it in the queue for ever; it says itself which frames are missing.
        const std::string submit = makeFarmFiles(Farm::Slurm, someJob()).value().submit;
        QVERIFY2(submit.starts_with("sbatch --dependency=afterany:$(sbatch --parsable "), submit.c_str());
    }

    void openJdJoinsTheFramesThatAreAskedForOnSubmission()
    {
        FarmJob job = someJob();
        job.joinWords.insert(job.joinWords.end(), {"--frames", textOf(job.frames)});
        const FarmFiles files = makeFarmFiles(Farm::OpenJd, job).value();
        const QJsonObject root =
            QJsonDocument::fromJson(QByteArray::fromStdString(files.files.at(0).contents)).object();
        const QJsonArray words = root["steps"][1]["script"]["actions"]["onRun"]["args"].toArray();
        QVERIFY(words.contains("{{Param.Frames}}"));
        QVERIFY(!words.contains(QString::fromStdString(textOf(job.frames))));
    }

    void noFarmGetsLongerTasksThanItTakes()
    {
        FarmJob job = someJob();
        for (const Farm farm : kAllFarms) {
            job.folder = "/mnt/show";
            job.perTask = std::min(mostPerTask(farm), 100'000);
            QVERIFY(makeFarmFiles(farm, job).ok());
            if (mostPerTask(farm) < 100'000) {
                job.perTask = mostPerTask(farm) + 1;
                const Result<FarmFiles> made = makeFarmFiles(farm, job);
                QVERIFY(!made.ok());
                QVERIFY2(made.error().text().find(std::to_string(mostPerTask(farm))) != std::string::npos,
                    made.error().text().c_str());
            }
        }
        QVERIFY(mostPerTask(Farm::OpenJd) <= 150);
    }

    void linesOfFilesStayLines()
    {
        FarmJob job = someJob();
        job.name = "a\n#SBATCH --evil=1";
        const std::string script = fileThatEnds(makeFarmFiles(Farm::Slurm, job).value(), "1.slurm.sh").contents;
        QVERIFY2(script.find("\n#SBATCH --evil") == script.rfind("\n#SBATCH --evil")
                && script.find("\"a__SBATCH --evil=1\"") != std::string::npos,
            script.c_str());
    }

    void namesThatAFarmCannotWriteAreRefused()
    {
        FarmJob job = someJob();
        QVERIFY(!makeFarmFiles(Farm::Deadline, job).ok()); // a double quote in the folder
        job.folder = "/mnt/show";
        QVERIFY(makeFarmFiles(Farm::Deadline, job).ok());
        job.output = "a{{b}}_####.png";
        const Result<FarmFiles> made = makeFarmFiles(Farm::OpenJd, job);
        QVERIFY(!made.ok());
        QVERIFY2(made.error().text().find("{{") != std::string::npos, made.error().text().c_str());
        QVERIFY(makeFarmFiles(Farm::Slurm, job).ok());
    }

    void deadlineCountsInItsOwnWay()
    {
        FarmJob job = someJob();
        job.folder = "/mnt/a b";
        const FarmFiles files = makeFarmFiles(Farm::Deadline, job).value();
        QCOMPARE(files.files.size(), std::size_t{5});
        const std::string info = fileThatEnds(files, "烟.deadline.job").contents;
        QVERIFY2(info.find("Frames=10-31x2\nChunkSize=4\n") != std::string::npos, info.c_str());
        const std::string plugin = fileThatEnds(files, "烟.deadline.plugin").contents;
        QVERIFY2(plugin.find(
                     "Arguments=render <QUOTE>/mnt/a b/-rök 烟.fumage.json<QUOTE> --frames <STARTFRAME>-<ENDFRAME>:2 ")
                != std::string::npos,
            plugin.c_str());
    }
};

QTEST_GUILESS_MAIN(FarmTest)
#include "farm_test.moc"
