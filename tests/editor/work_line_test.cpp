// The line over the viewport that says what is being done.
#include "editor_helpers.h"

#include "ui/viewport/work_line.h"

#include <QSet>
#include <QToolButton>

using namespace fumage;
using namespace fumage::tests;

class WorkLineTest : public QObject {
    Q_OBJECT

private slots:
    void everyPhaseIsNamedWithWhatIsKnownOfIt()
    {
        QSet<QString> texts;
        for (const Phase phase : {Phase::Air, Phase::Steps, Phase::Light, Phase::Paint}) {
            texts += WorkLine::textFor(phase, -1.0, -1.0);
            QVERIFY(!WorkLine::textFor(phase, -1.0, -1.0).contains(u'%'));
            QVERIFY(WorkLine::textFor(phase, 0.161, -1.0).contains(u"16 %"_q));
            const QString whole = WorkLine::textFor(phase, 0.161, 20.4);
            QVERIFY2(whole.contains(u"16 %"_q) && whole.contains(u"20 s"_q), qPrintable(whole));
            QVERIFY(WorkLine::textFor(phase, 0.5, 300.0).contains(u"5 min"_q));
        }
        QCOMPARE(texts.size(), 4);
        QVERIFY(!texts.contains(QString()));
    }

    void itComesWhereSomethingTakesLongAndGoesWhenThatIsDone()
    {
        QWidget window;
        WorkLine line(&window);
        window.show();
        line.follow(Phase::Air, 0.1);
        QVERIFY(line.isHidden());
        QTRY_VERIFY(!line.isHidden());
        QVERIFY(line.text().contains(u"10 %"_q));
        line.follow(Phase::Air, 0.4);
        QVERIFY2(line.text().contains(u"40 %"_q) && line.text().contains(u"about"_q), qPrintable(line.text()));
        line.follow(Phase::Steps, -1.0);
        QVERIFY(!line.text().contains(u'%'));
        line.follow(Phase::Idle, 1.0);
        QTRY_VERIFY(line.isHidden());
    }

    void picturesThatFollowOneAnotherQuicklyBringNoLine()
    {
        QWidget window;
        WorkLine line(&window);
        window.show();
        constexpr int kLongerThanTheDelayMs = 700;
        const bool isSeen = QTest::qWaitFor(
            [&] {
                for (const Phase phase : {Phase::Steps, Phase::Light, Phase::Paint, Phase::Idle}) {
                    line.follow(phase, -1.0);
                }
                return !line.isHidden();
            },
            kLongerThanTheDelayMs);
        QVERIFY(!isSeen);
    }

    void whatIsStoppedCanGoOn()
    {
        QWidget window;
        WorkLine line(&window);
        window.show();
        auto* button = line.findChild<QToolButton*>(u"workLine.button"_q);
        QSignalSpy stopped(&line, &WorkLine::stopped);
        QSignalSpy resumed(&line, &WorkLine::resumed);
        line.follow(Phase::Air, 0.1);
        QTRY_VERIFY(!line.isHidden());
        const QString stop = button->text();
        button->click();
        QCOMPARE(stopped.size(), 1);
        line.showStopped(true);
        QVERIFY(!line.isHidden() && button->text() != stop && !line.text().contains(u'%'));
        button->click();
        QCOMPARE(resumed.size(), 1);
        line.showStopped(false);
        QVERIFY(line.isHidden());
        QVERIFY(!button->accessibleName().isEmpty() && !line.accessibleName().isEmpty());
    }
};

FUMAGE_TEST_MAIN(WorkLineTest)
#include "work_line_test.moc"
