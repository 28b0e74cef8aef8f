#include "editor_helpers.h"

#include "ui/timeline/player.h"
#include "ui/timeline/timeline_bar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QSpinBox>
#include <QToolButton>

using namespace fumage;
using namespace fumage::tests;

class TimelineTest : public QObject {
    Q_OBJECT

private slots:
    void playingGoesThroughEveryFrameAndStartsAgain()
    {
        Player player;
        player.setTimeline(5, 240);
        QList<int> frames;
        connect(&player, &Player::frameChanged, this, [&](int frame) { frames += frame; });
        player.play();
        QTRY_VERIFY(frames.size() >= 7);
        QCOMPARE(QList<int>(frames.mid(0, 7)), (QList<int>{1, 2, 3, 4, 0, 1, 2}));
    }

    void withoutRepeatItStopsAtTheEnd()
    {
        Player player;
        player.setTimeline(4, 240);
        player.setRepeats(false);
        player.play();
        QTRY_VERIFY(!player.isPlaying());
        QCOMPARE(player.frame(), 3);
        player.play();
        QCOMPARE(player.frame(), 0);
    }

    void onlyTheRangeIsPlayed()
    {
        Player player;
        player.setTimeline(100, 240);
        player.setRange(10, 13);
        QSet<int> frames;
        player.setFrame(10);
        connect(&player, &Player::frameChanged, this, [&](int frame) { frames += frame; });
        player.play();
        QTRY_COMPARE(frames, (QSet<int>{10, 11, 12, 13}));
    }

    void aHeldPlayerWaitsForItsPicture()
    {
        Player player;
        player.setTimeline(100, 240);
        player.setHeld(true);
        QTimer timer;
        timer.start(0);
        QSignalSpy ticks(&timer, &QTimer::timeout);
        player.play();
        QTRY_VERIFY(ticks.size() > 200);
        QCOMPARE(player.frame(), 0);
        player.setHeld(false);
        QTRY_VERIFY(player.frame() > 0);
    }

    void framesOutsideOfTheTimelineAreClamped()
    {
        Player player;
        player.setTimeline(10, 30);
        player.setFrame(99);
        QCOMPARE(player.frame(), 9);
        player.setFrame(-5);
        QCOMPARE(player.frame(), 0);
        player.setFrame(9);
        player.setTimeline(4, 30);
        QCOMPARE(player.frame(), 3);
        QCOMPARE(player.last(), 3);
    }

    void theRulerScrubsAndSetsTheRange()
    {
        Document document;
        Player player;
        TimelineBar bar(document, player);
        bar.resize(800, 80);
        bar.show();
        QVERIFY(QTest::qWaitForWindowExposed(&bar));
        QCOMPARE(player.length(), document.effect().timeline.length);
        TimelineRuler& ruler = bar.ruler();
        const auto at = [&](int frame, int y) { return QPoint(qRound(ruler.xOf(frame)), y); };
        dragMouse(ruler, at(0, 30), at(75, 30));
        QCOMPARE(player.frame(), 75);
        dragMouse(ruler, at(75, 30), at(20, 30));
        QCOMPARE(player.frame(), 20);
        dragMouse(ruler, at(149, 5), at(100, 5));
        QCOMPARE(player.last(), 100);
        dragMouse(ruler, at(0, 5), at(30, 5));
        QCOMPARE(player.first(), 30);
    }

    void theButtonsAndFieldsDriveThePlayer()
    {
        Document document;
        Player player;
        TimelineBar bar(document, player);
        const auto click = [&](const QString& name) { bar.findChild<QToolButton*>(name)->click(); };
        auto* frame = bar.findChild<QSpinBox*>(u"frameField"_q);
        click(u"toEnd"_q);
        QCOMPARE(player.frame(), player.last());
        click(u"stepBack"_q);
        QCOMPARE(frame->value(), player.last() - 1);
        click(u"toStart"_q);
        click(u"stepForward"_q);
        QCOMPARE(frame->value(), 1);
        frame->setValue(7);
        QCOMPARE(player.frame(), 7);
        const bool repeated = player.repeats();
        click(u"repeat"_q);
        QCOMPARE(player.repeats(), !repeated);
        auto* speed = bar.findChild<QComboBox*>(u"playSpeed"_q);
        speed->setCurrentIndex(speed->findData(0.5));
        QCOMPARE(player.speed(), 0.5);
        click(u"playButton"_q);
        QVERIFY(player.isPlaying());
        click(u"playButton"_q);
        QVERIFY(!player.isPlaying());
    }

    void theSeamlessLoopIsAParameterOfTheDocumentAndNoRepeat()
    {
        Document document;
        Player player;
        TimelineBar bar(document, player);
        auto* loop = bar.findChild<QCheckBox*>(u"seamlessLoop"_q);
        QCOMPARE(loop->text(), u"Seamless loop"_q);
        QVERIFY(bar.findChild<QToolButton*>(u"repeat"_q)->toolTip().startsWith(u"Repeat playback"_q));
        const bool repeated = player.repeats();
        loop->click();
        QVERIFY(document.effect().timeline.loop);
        QCOMPARE(player.repeats(), repeated);
        document.undoStack()->undo();
        QVERIFY(!loop->isChecked());
    }

    void onANarrowScreenControlsGoRatherThanBeingCutOff_data()
    {
        QTest::addColumn<int>("width");
        for (const int width : {300, 420, 520, 900}) {
            QTest::addRow("%d", width) << width;
        }
    }
    void onANarrowScreenControlsGoRatherThanBeingCutOff()
    {
        QFETCH(int, width);
        Document document;
        Player player;
        TimelineBar bar(document, player);
        bar.resize(width, bar.sizeHint().height());
        bar.show();
        QVERIFY(QTest::qWaitForWindowExposed(&bar));
        for (const char* name : {"frameField", "seamlessLoop", "playSpeed", "frameRateField"}) {
            const auto* control = bar.findChild<QWidget*>(QLatin1String(name));
            QVERIFY2(control->isHidden() || control->width() >= control->sizeHint().width(), name);
            QVERIFY2(control->isHidden() || control->geometry().right() < width, name);
        }
        QVERIFY(!bar.findChild<QWidget*>(u"frameField"_q)->isHidden());
        QCOMPARE(bar.findChild<QWidget*>(u"frameRateField"_q)->isHidden(), width < 600);
    }

    void theFrameRateIsAParameterOfTheDocument()
    {
        Document document;
        Player player;
        TimelineBar bar(document, player);
        auto* rate = bar.findChild<QSpinBox*>(QStringLiteral("frameRateField"));
        rate->setValue(24);
        QCOMPARE(document.effect().timeline.frameRate, 24);
        document.undoStack()->undo();
        QCOMPARE(rate->value(), Effect().timeline.frameRate);
    }
};

FUMAGE_TEST_MAIN(TimelineTest)
#include "timeline_test.moc"
