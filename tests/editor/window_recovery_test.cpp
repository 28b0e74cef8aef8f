// What a program that is killed leaves behind.
#include "window_fixture.h"

#include "ui/document/recovery.h"
#include "ui/widgets/message_bar.h"

#include "core/system/file.h"
#include "core/effect/known_parameter.h"
#include "core/preset/preset_file.h"

#include <QAction>
#include <QDockWidget>
#include <QProcess>
#include <QLabel>
#include <QTimer>

#include <cstdio>

using namespace fumage;
using namespace fumage::tests;

class WindowRecoveryTest : public WindowFixture {
    Q_OBJECT

private slots:
    void whatWasNotSavedIsThereAgainAfterAKill()
    {
        QProcess victim;
        startVictim(victim, {});
        QVERIFY(victim.waitForReadyRead(20000)); // it says so when its copy is on the disk
        victim.kill();
        QVERIFY(victim.waitForFinished());
        QCOMPARE(victim.exitStatus(), QProcess::CrashExit);

        const QString asked = m_folder.filePath(u"asked.json"_q);
        QVERIFY(writePresetFile(asked.toStdString(), smallPreset()).ok());
        m_session->start({asked});
        MainWindow* recovered = windowOn(u"/somewhere/mine.json"_q);
        QVERIFY(recovered != nullptr && windowOn(asked) != nullptr);
        QTRY_VERIFY(recovered->isActiveWindow()); // in front of the file
        QCOMPARE(recovered->document().effect().motion.gravity, 6.5F);
        QCOMPARE(recovered->document().filePath(), u"/somewhere/mine.json"_q);
        QVERIFY(recovered->isWindowModified());
        QVERIFY(recovered->messages().says(u"notice.recovered"_q));
        QVERIFY(Recovery::find(recoveryFolder()).works.empty()); // this program has it
        QTRY_VERIFY_WITH_TIMEOUT(
            recoveryFolder().entryList({u"*.trial"_q}).isEmpty(), 20000); // what has been shown is harmless
    }

    void exportsThatWereNotFinishedAreOfferedAfterAKill()
    {
        const QString output = m_folder.filePath(u"out/smoke_####.png"_q);
        QProcess victim;
        startVictim(victim, {{u"FUMAGE_TEST_EXPORT"_q, output}});
        QVERIFY(victim.waitForReadyRead(20000)); // it says so when its first file is written
        Session beside; // while it lives its exports are its own
        beside.exports().takeLeftovers();
        QCOMPARE(beside.exports().rowCount(), 0);
        victim.kill();
        QVERIFY(victim.waitForFinished());

        m_session->start({});
        ExportQueue& queue = m_session->exports();
        QCOMPARE(queue.rowCount(), 2);
        QCOMPARE(queue.held(), 2);
        QCOMPARE(queue.index(0).data().toString(), u"Long"_q);
        QCOMPARE(queue.at(0).job->preset.scene.layers[0].motion.gravity, 6.5F);
        for (const QFileInfo& file : QDir(m_folder.filePath(u"out"_q)).entryInfoList({u"*.png"_q}, QDir::Files)) {
            QVERIFY2(!QImage(file.filePath()).isNull(), qPrintable(file.filePath()));
        }
        auto* dock = childOf<QDockWidget>(*otherWindow(), u"dock.queue"_q);
        QTRY_VERIFY(dock->isVisible());
        queue.remove(0);
        queue.startHeld();
        QTRY_COMPARE_WITH_TIMEOUT(queue.at(0).state, ExportState::Done, 60000);
        QVERIFY(QFile::exists(m_folder.filePath(u"out/short.png"_q)));
    }

    void aCopyThatCannotBeReadIsMentioned()
    {
        const QString copy = recoveryFolder().filePath(u"left.json"_q);
        const QString file = m_folder.filePath(u"smoke.json"_q);
        QVERIFY(writeFileAtomically(copy.toStdString(), std::string_view("{ half a fi")).ok());
        QVERIFY(writePresetFile(file.toStdString(), smallPreset()).ok());
        m_session->start({file});
        const QString said = childOf<QLabel>(*otherWindow(), u"notice.left.text"_q)->text();
        QVERIFY2(said.contains(copy), qPrintable(said));
        QVERIFY(QFile::remove(copy));
    }

    /// As at the end of a Windows session, where the program is told to quit after it has been told that it ends.
    void theEndOfTheSessionAsksNothingAndKeepsTheWork()
    {
        const QString file = m_folder.filePath(u"work.json"_q);
        QVERIFY(writePresetFile(file.toStdString(), smallPreset()).ok());
        m_session->start({file});
        MainWindow* window = windowOn(file);
        QVERIFY(window != nullptr);
        window->document().edit(knownParameter("motion.gravity"), 6.5F);
        auto* smokeOnly = window->findChild<QAction*>(u"view.smokeOnly"_q);
        smokeOnly->setChecked(true);
        m_session->keepWork();
        m_session->end();
        bool asked = false;
        QTimer::singleShot(0, [&asked] {
            if (QWidget* question = QApplication::activeModalWidget()) {
                asked = true;
                question->close();
            }
        });
        const QPointer<MainWindow> closed(window);
        QVERIFY(window->close() && !asked);
        QVERIFY(!smokeOnly->isChecked()); // or the next start would have no panels
        QTRY_VERIFY(closed.isNull());
        m_session.reset();
        Recovery::Leftovers left = Recovery::find(recoveryFolder());
        QCOMPARE(left.works.size(), std::size_t{1});
        QCOMPARE(left.works.front().preset.scene.layers[0].motion.gravity, 6.5F);
    }

private:
    /// Another program of this kind, in the same folders.
    static void startVictim(QProcess& victim, const QMap<QString, QString>& variables)
    {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("FUMAGE_TEST_VICTIM"), QStringLiteral("1"));
        for (auto each = variables.begin(); each != variables.end(); ++each) {
            environment.insert(each.key(), each.value());
        }
        victim.setProcessEnvironment(environment);
        victim.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        victim.start(QCoreApplication::applicationFilePath());
    }

    static QDir recoveryFolder() { return QDir(Settings::recoveryFolder()); }

    static MainWindow* windowOn(const QString& path)
    {
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            auto* window = qobject_cast<MainWindow*>(widget);
            if (window != nullptr && window->document().filePath() == path) {
                return window;
            }
        }
        return nullptr;
    }
};

/// Adds exports of which the first does not end by itself.
static void addExports(ExportQueue& queue, const QString& output)
{
    ExportJob job{"Long", smallPreset(), {}};
    job.preset.scene.layers[0].motion.gravity = 6.5F;
    job.preset.scene.output.width = job.preset.scene.output.height = 64;
    job.plan.output = output.toStdString();
    job.plan.frames = {0, 100'000, 1};
    static_cast<void>(queue.add(job));
    job.name = "Short";
    job.plan.kind = ExportKind::Picture;
    job.plan.output.replace_filename("short.png");
    static_cast<void>(queue.add(job));
}

/// The program that is killed while it has unsaved work, or exports.
static int runVictim(int argc, char** argv)
{
    QApplication application(argc, argv);
    Session session;
    const QString output = qEnvironmentVariable("FUMAGE_TEST_EXPORT");
    if (!output.isEmpty()) {
        addExports(session.exports(), output);
    }
    MainWindow* window = session.openWindow();
    window->document().load(smallPreset(), u"/somewhere/mine.json"_q);
    if (output.isEmpty()) {
        window->document().edit(knownParameter("motion.gravity"), 6.5F);
    }
    const QDir folder = output.isEmpty() ? QDir(Settings::recoveryFolder()) : QFileInfo(output).dir();
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &timer, [folder] {
        if (!folder.entryList({u"*.json"_q, u"*.png"_q}).isEmpty()) {
            std::puts("saved");
            std::fflush(stdout);
        }
    });
    timer.start(20);
    return QApplication::exec();
}

int main(int argc, char** argv)
{
    return qEnvironmentVariableIsSet("FUMAGE_TEST_VICTIM") ? runVictim(argc, argv)
                                                           : runTest<WindowRecoveryTest>(argc, argv);
}
#include "window_recovery_test.moc"
