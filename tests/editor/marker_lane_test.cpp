// Markers over the ruler: each gesture one undo step, names as they are, nothing where there is none.

#include "timeline_fixture.h"

#include "ui/shell/action_table.h"
#include "ui/shell/play_actions.h"
#include "ui/widgets/gesture.h"

#include <QLineEdit>
#include <QMainWindow>
#include <QToolTip>

using namespace fumage;
using namespace fumage::tests;

class MarkerLaneTest : public TimelineFixture {
    Q_OBJECT

private slots:
    void theyTakeNoRoomWhereThereIsNone()
    {
        QVERIFY(!lane().isVisible());
        m_player->setFrame(15);
        addMarkerHere(*m_document);
        QTRY_VERIFY(lane().isVisible());
        QCOMPARE(lane().height(), MarkerLane::kHeight);
        m_document->undoStack()->undo();
        QVERIFY(!lane().isVisible());
    }

    void newOnesHaveNamesOfTheirOwn()
    {
        m_player->setFrame(30);
        addMarkerHere(*m_document);
        m_player->setFrame(15);
        addMarkerHere(*m_document);
        addMarkerHere(*m_document); // one is there
        QVERIFY((markers() == std::vector<Marker>{{"Marker 2", 0.5}, {"Marker 1", 1.0}}));
        QCOMPARE(m_document->undoStack()->count(), 2);
        QCOMPARE(m_document->undoStack()->undoText(), u"Add a marker"_q);
        m_document->undoStack()->undo();
        QCOMPARE(markers().size(), std::size_t{1});
        m_document->undoStack()->redo();
        QCOMPARE(markers().size(), std::size_t{2});
    }

    void thereAreNoMoreThanMayBe()
    {
        set(std::vector<Marker>(kMaxMarkers, {"x", 0.5}));
        const int steps = m_document->undoStack()->count();
        addMarkerHere(*m_document);
        QCOMPARE(markers().size(), kMaxMarkers);
        QCOMPARE(m_document->undoStack()->count(), steps);
    }

    void aClickGoesThere()
    {
        set({{"Boom", 1.0}});
        QTest::mouseClick(&lane(), Qt::LeftButton, {}, hold(0));
        QCOMPARE(m_player->frame(), 30);
        QVERIFY((markers() == std::vector<Marker>{{"Boom", 1.0}}));
        QCOMPARE(m_document->undoStack()->count(), 1);
    }

    void theyAreDraggedByFrames()
    {
        set({{"a", 0.5}, {"b", 1.0}, {"c", 3.0}});
        drag(0, 30);
        QVERIFY((markers() == std::vector<Marker>{{"b", 1.0}, {"a", 1.5}, {"c", 3.0}})); // past the next one
        QCOMPARE(m_document->undoStack()->count(), 2);
        QCOMPARE(m_document->undoStack()->undoText(), u"Move a marker"_q);
        drag(0, -60); // none gets before the beginning
        QCOMPARE(markers().front().seconds, 0.0);
        drag(2, 1000); // nor where it is not seen
        QCOMPARE(markers().back().seconds, (m_player->length() - 1) / 30.0);
        for (int i = 0; i < 3; ++i) {
            m_document->undoStack()->undo();
        }
        QVERIFY((markers() == std::vector<Marker>{{"a", 0.5}, {"b", 1.0}, {"c", 3.0}}));
    }

    void aDragThatIsTakenBackLeavesNothing()
    {
        set({{"a", 0.5}, {"b", 1.0}});
        const QPoint from = hold(0);
        QTest::mousePress(&lane(), Qt::LeftButton, {}, from);
        for (const int way : {40, 90}) {
            const QPoint at = from + QPoint(way, 0);
            QMouseEvent move(
                QEvent::MouseMove, at, lane().mapToGlobal(at), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(&lane(), &move);
        }
        QVERIFY(!(markers() == std::vector<Marker>{{"a", 0.5}, {"b", 1.0}}));
        DragCancel cancel;
        QApplication::sendEvent(&lane(), &cancel);
        QVERIFY(cancel.isAccepted());
        QTest::mouseRelease(&lane(), Qt::LeftButton, {}, from + QPoint(90, 0));
        QVERIFY((markers() == std::vector<Marker>{{"a", 0.5}, {"b", 1.0}}));
        QCOMPARE(m_document->undoStack()->count(), 1);
    }

    void aDoubleClickNamesOne()
    {
        set({{"a", 0.5}, {"b", 1.0}});
        write(0, u" <b>Boom</b> & %1 "_q, Qt::Key_Return);
        QCOMPARE(markers()[0].name, std::string("<b>Boom</b> & %1"));
        QCOMPARE(markers()[0].seconds, 0.5);
        QCOMPARE(m_document->undoStack()->count(), 2);
        QCOMPARE(m_document->undoStack()->undoText(), u"Rename a marker"_q);
        write(0, u"other"_q, Qt::Key_Escape);
        write(0, u"  "_q, Qt::Key_Return); // no name
        QCOMPARE(markers()[0].name, std::string("<b>Boom</b> & %1"));
        QCOMPARE(m_document->undoStack()->count(), 2);
        write(0, QString(100, QChar(0x70df)), Qt::Key_Return); // three bytes each
        QCOMPARE(markers()[0].name.size(), std::size_t{99});
        QVERIFY(checkMarkers(markers()).ok());
        m_document->undoStack()->undo();
        m_document->undoStack()->undo();
        QCOMPARE(markers()[0].name, std::string("a"));
    }

    void writingEndsWhereMarkersChange()
    {
        set({{"a", 0.5}, {"b", 1.0}});
        lane().rename(1);
        QVERIFY(editor() != nullptr);
        removeMarker(*m_document, 0);
        QTRY_VERIFY(editor() == nullptr);
        QVERIFY((markers() == std::vector<Marker>{{"b", 1.0}}));
        QCOMPARE(m_document->undoStack()->undoText(), u"Remove a marker"_q);
    }

    void tipsShowNamesAsTheyAre()
    {
        set({{"<b>Boom</b>", 0.5}});
        const QPoint at = hold(0);
        QHelpEvent help(QEvent::ToolTip, at, lane().mapToGlobal(at));
        QApplication::sendEvent(&lane(), &help);
        QVERIFY2(QToolTip::text().contains(u"&lt;b&gt;Boom"_q), qPrintable(QToolTip::text()));
        QToolTip::hideText();
    }

    void flagsLieAtTheirTimesAndNotOverOneAnother()
    {
        set({{"a rather long name", 0.5}, {"another", 1.0}, {"third", 1.0}});
        for (std::size_t marker = 0; marker < 3; ++marker) {
            QCOMPARE(lane().flagOf(marker).left(), m_bar->ruler().xOf(markers()[marker].seconds * 30.0));
        }
        QVERIFY(lane().flagOf(0).right() <= lane().flagOf(1).left());
        QCOMPARE(lane().markerUnder(lane().flagOf(0).center()), std::optional<std::size_t>(0));
        QCOMPARE(lane().markerUnder(lane().flagOf(2).center()), std::optional<std::size_t>(2)); // the last of its time
        QVERIFY(!lane().markerUnder({m_bar->ruler().xOf(100.0), 9.0}));
    }

    void anotherFrameRateMovesNone()
    {
        set({{"a", 0.5}});
        m_document->edit(*findParameter("timeline.frame_rate"), 60);
        QVERIFY((markers() == std::vector<Marker>{{"a", 0.5}}));
        QCOMPARE(lane().flagOf(0).left(), m_bar->ruler().xOf(30.0));
    }

    void layersKnowNothingOfThem()
    {
        set({{"a", 0.5}});
        QSignalSpy layers(m_document.get(), &Document::layersChanged);
        bool isOfScene = false;
        connect(m_document.get(), &Document::effectChanged, this,
            [&](const EffectChange& change) { isOfScene = isOfScene || change.isOfScene; });
        addMarkerHere(*m_document);
        QVERIFY(layers.isEmpty() && !isOfScene); // no picture is made again
        QVERIFY(m_document->isModified());
        m_document->edit(*findParameter("emitter.seed"), 5U);
        QVERIFY(isOfScene);
    }

    void actionsSetThemAndGoToThem()
    {
        QMainWindow window;
        const ActionSet actions(&window);
        connectMarkerActions(actions, *m_player, *m_document);
        m_player->setFrame(20);
        actions.get("play.addMarker").trigger();
        m_player->setFrame(60);
        actions.get("play.addMarker").trigger();
        QCOMPARE(markers().size(), std::size_t{2});
        m_player->setFrame(0);
        const auto frameAfter = [&](const char* action) {
            actions.get(action).trigger();
            return m_player->frame();
        };
        QCOMPARE(frameAfter("play.previousMarker"), 0); // there is none
        QCOMPARE(frameAfter("play.nextMarker"), 20);
        QCOMPARE(frameAfter("play.nextMarker"), 60);
        QCOMPARE(frameAfter("play.nextMarker"), 60);
        QCOMPARE(frameAfter("play.previousMarker"), 20);
    }

private:
    MarkerLane& lane() { return m_bar->markers(); }
    [[nodiscard]] const std::vector<Marker>& markers() const { return m_document->scene().markers; }
    /// The first that is there; of those that are to go none.
    QLineEdit* editor()
    {
        for (auto* each : lane().findChildren<QLineEdit*>(u"markerName"_q)) {
            if (each->isVisible()) {
                return each;
            }
        }
        return nullptr;
    }
    void set(const std::vector<Marker>& wanted)
    {
        replaceMarkers(*m_document, wanted, u"Set"_q);
        m_bar->layout()->activate();
        QCoreApplication::processEvents();
    }
    /// Where the hand takes a flag.
    QPoint hold(std::size_t marker) { return lane().flagOf(marker).topLeft().toPoint() + QPoint(3, 8); }
    void drag(std::size_t marker, int frames)
    {
        const double perFrame = m_bar->ruler().xOf(1.0) - m_bar->ruler().xOf(0.0);
        const QPoint from = hold(marker);
        dragMouse(lane(), from, from + QPoint(static_cast<int>(std::lround(frames * perFrame)), 0));
    }
    void write(std::size_t marker, const QString& name, Qt::Key end)
    {
        QTest::mouseDClick(&lane(), Qt::LeftButton, {}, hold(marker));
        QVERIFY(editor() != nullptr);
        editor()->setText(name);
        QTest::keyClick(editor(), end);
        QVERIFY(editor() == nullptr);
    }
};

FUMAGE_TEST_MAIN(MarkerLaneTest)
#include "marker_lane_test.moc"
