// What a program that is killed leaves behind.
#include "window_fixture.h"

#include "ui/document/recovery.h"

#include "core/base/file.h"
#include "core/effect/known_parameter.h"

#include <QProcess>
#include <QStatusBar>
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
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("FUMAGE_TEST_VICTIM"), QStringLiteral("1"));
        victim.setProcessEnvironment(environment);
        victim.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        victim.start(QCoreApplication::applicationFilePath());
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
        QVERIFY(Recovery::find(recoveryFolder()).works.empty()); // this program has it
        QTRY_VERIFY_WITH_TIMEOUT(recoveryFolder().entryList({u"*.trial"_q}).isEmpty(), 20000); // what has been shown is harmless
    }

    void aCopyThatCannotBeReadIsMentioned()
    {
        const QString copy = recoveryFolder().filePath(u"left.json"_q);
        const QString file = m_folder.filePath(u"smoke.json"_q);
        QVERIFY(writeFileAtomically(copy.toStdString(), std::string_view("{ half a fi")).ok());
        QVERIFY(writePresetFile(file.toStdString(), smallPreset()).ok());
        m_session->start({file});
        QVERIFY2(otherWindow()->statusBar()->currentMessage().contains(copy), qPrintable(otherWindow()->statusBar()->currentMessage()));
        QVERIFY(QFile::remove(copy));
    }

private:
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

/// The program that is killed while it has unsaved work.
static int runVictim(int argc, char** argv)
{
    QApplication application(argc, argv);
    Session session;
    MainWindow* window = session.openWindow();
    window->document().load(smallPreset(), u"/somewhere/mine.json"_q);
    window->document().edit(knownParameter("motion.gravity"), 6.5F);
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &timer, [] {
        if (!QDir(Settings::recoveryFolder()).entryList({u"*.json"_q}).isEmpty()) {
            std::puts("saved");
            std::fflush(stdout);
        }
    });
    timer.start(20);
    return QApplication::exec();
}

int main(int argc, char** argv)
{
    return qEnvironmentVariableIsSet("FUMAGE_TEST_VICTIM") ? runVictim(argc, argv) : runTest<WindowRecoveryTest>(argc, argv);
}
#include "window_recovery_test.moc"
