// The graph of key frames: axes, keys and handles under the hand, each gesture one undo step.

#include "timeline_fixture.h"

#include "ui/document/locks.h"
#include "ui/document/number_text.h"
#include "ui/document/solo.h"
#include "ui/panels/effect_panel.h"
#include "ui/panels/parameter_row.h"
#include "ui/shell/action_table.h"
#include "ui/shell/play_actions.h"
#include "ui/shell/settings.h"
#include "ui/timeline/key_drag.h"
#include "ui/widgets/gesture.h"

#include "core/effect/known_parameter.h"

#include <QLabel>
#include <QToolButton>

#include <algorithm>
#include <cmath>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr const Parameter& kRate = knownParameter("emitter.rate");
constexpr const Parameter& kEmission = knownParameter("glow.emission");
constexpr const Parameter& kPosition = knownParameter("emitter.position");
constexpr const Parameter& kFireColours = knownParameter("glow.emission_colour");

Track trackOf(const Parameter& parameter, std::vector<KeyFrame> keys)
{
    return {&parameter, std::move(keys)};
}

float numberOf(const KeyFrame& key)
{
    return std::get<float>(key.value);
}

/// The values of a track of numbers at many times, outside of its keys too.
std::vector<float> valuesOf(const Track& track)
{
    constexpr int kCount = 200;
    std::vector<float> values;
    for (int i = 0; i < kCount; ++i) {
        values.push_back(std::get<float>(track.at(0.03 * i)));
    }
    return values;
}

float largestDifference(const std::vector<float>& a, const std::vector<float>& b)
{
    float largest = 0.0F;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, std::abs(a[i] - b[i]));
    }
    return largest;
}

} // namespace

class KeyGraphTest : public TimelineFixture {
    Q_OBJECT

private slots:
    void theGraphTakesNoRoomWhereNothingChanges()
    {
        QVERIFY(!graph().isVisible());
        setTracks({trackOf(kRate, {{0.0, 0.0F}, {1.0, 1.0F}})});
        QVERIFY(graph().isVisible());
        QCOMPARE(graph().height(), KeyGraph::kHeight);
        QSignalSpy toggles(m_bar.get(), &TimelineBar::graphToggled);
        auto* button = m_bar->findChild<QToolButton*>(u"graphButton"_q);
        QVERIFY(button->isChecked());
        button->click();
        QVERIFY(!graph().isVisible());
        QVERIFY(!m_bar->showsGraph());
        QCOMPARE(toggles.count(), 1);
        QVERIFY(!toggles.first().first().toBool());
    }

    void whetherTheGraphIsShownIsRemembered()
    {
        setTracks({trackOf(kRate, {{0.0, 0.0F}, {1.0, 1.0F}})});
        QWidget window;
        const ActionSet actions(&window);
        Settings settings;
        connectGraphAction(actions, *m_bar, settings);
        QVERIFY(!m_bar->showsGraph()); // nobody has asked for it
        actions.get("play.graph").toggle();
        QVERIFY(graph().isVisible());
        QVERIFY(settings.showsGraph());
        TimelineBar next(*m_document, *m_player);
        const ActionSet others(&window);
        connectGraphAction(others, next, settings);
        QVERIFY(next.showsGraph());
        m_bar->findChild<QToolButton*>(u"graphButton"_q)->click();
        QVERIFY(!actions.get("play.graph").isChecked());
        QVERIFY(!settings.showsGraph());
    }

    void theGraphIsDraggedToAHeightThatIsRemembered()
    {
        setTracks({trackOf(kRate, {{0.0, 0.0F}, {1.0, 1.0F}})});
        QWidget window;
        const ActionSet actions(&window);
        Settings settings;
        settings.setShowsGraph(true);
        connectGraphAction(actions, *m_bar, settings);
        auto* grip = m_bar->findChild<GraphGrip*>(u"graphGrip"_q);
        QVERIFY(grip->isVisible());
        const QPoint from = grip->rect().center();
        const auto drag = [&](int way) { // in one move: the grip may go with it
            QTest::mousePress(grip, Qt::LeftButton, {}, from);
            const QPoint to = from + QPoint(0, way);
            QMouseEvent event(QEvent::MouseMove, to, grip->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(grip, &event);
            QTest::mouseRelease(grip, Qt::LeftButton, {}, to);
        };
        drag(-40);
        QCOMPARE(m_bar->graphHeight(), KeyGraph::kHeight + 40);
        QCOMPARE(graph().maximumHeight(), KeyGraph::kHeight + 40);
        QCOMPARE(settings.graphHeight(0), KeyGraph::kHeight + 40);
        TimelineBar next(*m_document, *m_player);
        const ActionSet others(&window);
        connectGraphAction(others, next, settings);
        QCOMPARE(next.graphHeight(), KeyGraph::kHeight + 40);
        QMouseEvent idle(QEvent::MouseMove, from, grip->mapToGlobal(from + QPoint(0, 30)), Qt::NoButton, {}, {});
        QApplication::sendEvent(grip, &idle); // nobody holds it
        QCOMPARE(m_bar->graphHeight(), KeyGraph::kHeight + 40);
        QTest::mousePress(grip, Qt::LeftButton, {}, from);
        QMouseEvent up(
            QEvent::MouseMove, from, grip->mapToGlobal(from - QPoint(0, 30)), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(grip, &up);
        QCOMPARE(m_bar->graphHeight(), KeyGraph::kHeight + 70);
        DragCancel cancel; // Escape
        QApplication::sendEvent(grip, &cancel);
        QVERIFY(cancel.isAccepted());
        QTest::mouseRelease(grip, Qt::LeftButton, {}, from);
        QCOMPARE(m_bar->graphHeight(), KeyGraph::kHeight + 40);
        drag(2000);
        QCOMPARE(m_bar->graphHeight(), KeyGraph::kMinHeight);
        drag(-2000);
        QCOMPARE(m_bar->graphHeight(), KeyGraph::kMaxHeight);
        QTest::mouseDClick(grip, Qt::LeftButton, {}, from);
        QCOMPARE(m_bar->graphHeight(), KeyGraph::kHeight);
        settings.setGraphHeight(-7); // of a file
        connectGraphAction(others, next, settings);
        QCOMPARE(next.graphHeight(), KeyGraph::kMinHeight);
        settings.setGraphHeight(KeyGraph::kHeight);
        settings.setShowsGraph(false);
        m_bar->setShowsGraph(false);
        QVERIFY(!grip->isVisible());
    }

    void aDragChangesTimeAndValueInOneStep()
    {
        setTracks({trackOf(kEmission, {{0.0, 1.0F}, {1.0, 2.0F}, {2.0, 1.0F}})});
        const int steps = m_document->undoStack()->count();
        const QPoint from = graph().placeOf({&kEmission, 1.0}).toPoint();
        const QPoint to = from + QPoint(framesWide(9), 30);
        const double perPixel = graph().axis().perPixel();
        dragMouse(graph(), from, to);
        const Track& track = *m_document->track(kEmission);
        QCOMPARE(track.keys[1].seconds, 1.3);
        QVERIFY(std::abs(static_cast<double>(numberOf(track.keys[1])) - (2.0 - 30.0 * perPixel)) < 1e-4);
        QCOMPARE(m_document->undoStack()->count(), steps + 1);
        m_document->undoStack()->undo();
        QCOMPARE(m_document->track(kEmission)->keys[1], (KeyFrame{1.0, 2.0F}));
    }

    void shiftKeepsToTimeOrValue()
    {
        const Track before = trackOf(kEmission, {{0.0, 1.0F}, {1.0, 2.0F}, {2.0, 1.0F}});
        setTracks({before});
        const QPoint from = graph().placeOf({&kEmission, 1.0}).toPoint();
        dragMouse(graph(), from, from + QPoint(framesWide(6), 8), Qt::LeftButton, Qt::ShiftModifier);
        QCOMPARE(m_document->track(kEmission)->keys[1], (KeyFrame{1.2, 2.0F}));
        m_document->undoStack()->undo();
        dragMouse(graph(), from, from + QPoint(framesWide(1), 40), Qt::LeftButton, Qt::ShiftModifier);
        QCOMPARE(m_document->track(kEmission)->keys[1].seconds, 1.0);
        QVERIFY(numberOf(m_document->track(kEmission)->keys[1]) < 1.9F);
    }

    void altStretchesAsInTheLanes()
    {
        setTracks({trackOf(kEmission, {{0.5, 1.0F}, {1.0, 2.0F}, {1.5, 1.0F}})});
        graph().setFocus();
        QTest::keyClick(&graph(), Qt::Key_A, Qt::ControlModifier);
        const QPoint from = graph().placeOf({&kEmission, 1.5}).toPoint();
        dragMouse(graph(), from, from + QPoint(framesWide(30), 25), Qt::LeftButton, Qt::AltModifier);
        const Track& track = *m_document->track(kEmission);
        QCOMPARE(track.keys[0], (KeyFrame{0.5, 1.0F}));
        QCOMPARE(track.keys[1], (KeyFrame{1.5, 2.0F}));
        QCOMPARE(track.keys[2], (KeyFrame{2.5, 1.0F}));
        // Free slopes become gentler with it: the curve keeps its form.
        const glm::vec3 slope(3.0F, 0.0F, 0.0F);
        Track free = trackOf(kEmission, {{0.5, 1.0F}, {1.0, 2.0F, Ease::Free, slope, slope}, {1.5, 1.0F}});
        stretchSlopes(free, {{&kEmission, 0.5}, {&kEmission, 1.0}}, 1.0, 2.0);
        QCOMPARE(free.keys[1].slopeIn.x, 1.0F);
        QCOMPARE(free.keys[1].slopeOut.x, 1.0F);
    }

    void valuesStayInTheirRange()
    {
        setTracks({trackOf(kRate, {{0.0, 0.5F}, {1.0, 0.75F}, {2.0, 0.5F}})});
        const QPoint from = graph().placeOf({&kRate, 1.0}).toPoint();
        dragMouse(graph(), from, from - QPoint(0, 1000));
        QCOMPARE(numberOf(m_document->track(kRate)->keys[1]), 1.0F);
        dragMouse(graph(), graph().placeOf({&kRate, 0.0}).toPoint(), from + QPoint(-framesWide(60), 1000));
        QCOMPARE(m_document->track(kRate)->keys[0].seconds, 0.0);
        QCOMPARE(numberOf(m_document->track(kRate)->keys[0]), 0.0F);
    }

    void aChoiceIsMovedInTimeAlone()
    {
        setTracks({trackOf(kFireColours, {{0.0, 0}, {1.0, 1}})});
        const QPoint from = graph().placeOf({&kFireColours, 1.0}).toPoint();
        dragMouse(graph(), from, from + QPoint(framesWide(9), 60));
        const KeyFrame& key = m_document->track(kFireColours)->keys[1];
        QCOMPARE(key.seconds, 1.3);
        QCOMPARE(std::get<int>(key.value), 1);
        QVERIFY(!graph().handleOf({&kFireColours, 1.3}, false));
        // Its curve is a step, and nothing lies between its two values.
        const std::vector<GraphCurve>& curves = graph().curves();
        QCOMPARE(curves.size(), std::size_t{1});
        QVERIFY(std::all_of(curves[0].points.begin(), curves[0].points.end(),
            [](const GraphPoint& point) { return point.value == 0.0 || point.value == 1.0; }));
    }

    void oneComponentOfAVectorIsMoved()
    {
        setTracks({trackOf(kPosition, {{0.0, glm::vec3(0.0F, 1.0F, 2.0F)}, {1.0, glm::vec3(0.5F, 1.5F, 2.5F)}})});
        QCOMPARE(graph().curves().size(), std::size_t{3});
        const QPoint from = graph().placeOf({&kPosition, 1.0}, 1).toPoint();
        dragMouse(graph(), from, from - QPoint(0, 20));
        const auto value = std::get<glm::vec3>(m_document->track(kPosition)->keys[1].value);
        QCOMPARE(value.x, 0.5F);
        QVERIFY(value.y > 1.5F);
        QCOMPARE(value.z, 2.5F);
    }

    void aKeyThatIsAddedLeavesTheCurveAsItIs_data()
    {
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("second");
        QTest::addColumn<int>("frame");
        for (int ease = 0; ease < 4; ++ease) {
            for (const int frame : {12, 45, 80, 120}) {
                QTest::addRow("%s at %d", kEases[static_cast<std::size_t>(ease)].data(), frame)
                    << ease << ease << frame;
            }
        }
        QTest::addRow("auto and free") << 0 << 3 << 45;
        QTest::addRow("free and auto") << 3 << 0 << 45;
    }
    void aKeyThatIsAddedLeavesTheCurveAsItIs()
    {
        QFETCH(int, first);
        QFETCH(int, second);
        QFETCH(int, frame);
        const auto a = static_cast<Ease>(first);
        const auto b = static_cast<Ease>(second);
        const auto slopes = [](Ease ease, float in, float out) {
            return ease == Ease::Free ? std::pair(glm::vec3(in, 0.0F, 0.0F), glm::vec3(out, 0.0F, 0.0F))
                                      : std::pair(glm::vec3(0.0F), glm::vec3(0.0F));
        };
        const auto [in, out] = slopes(b, 0.5F, -1.0F);
        const Track before = trackOf(kEmission,
            {{0.5, 1.0F, a}, {1.0, 2.0F, b, in, out}, {2.0, 3.0F, a}, {3.0, 1.5F, b, in, out}, {3.5, 1.75F, a}});
        setTracks({before});
        const int steps = m_document->undoStack()->count();
        doubleClickOnTheCurve(frame);
        const Track after = *m_document->track(kEmission);
        QCOMPARE(after.keys.size(), before.keys.size() + 1);
        QVERIFY(keyAt(after, frame / 30.0) != nullptr);
        QCOMPARE(m_document->undoStack()->count(), steps + 1);
        const float difference = largestDifference(valuesOf(before), valuesOf(after));
        constexpr float kRounding = 3e-6F; // of values up to 3
        QVERIFY2(difference <= kRounding, qPrintable(QString::number(static_cast<double>(difference))));
        if (a == Ease::Hold && b == Ease::Hold) {
            QCOMPARE(difference, 0.0F);
        }
    }

    void aKeyThatIsAddedInALaneLeavesTheCurveToo()
    {
        const Track before = trackOf(kEmission, {{0.0, 1.0F}, {1.0, 3.0F}, {3.0, 2.0F}});
        setTracks({before});
        KeyLanes& lanes = m_bar->lanes();
        QTest::mouseDClick(
            &lanes, Qt::LeftButton, {}, lanes.placeOf({&kEmission, 1.0}).toPoint() + QPoint(framesWide(30), 0));
        QCOMPARE(m_document->track(kEmission)->keys.size(), std::size_t{4});
        QCOMPARE(lanes.selected(), (std::vector<KeyPlace>{{&kEmission, 2.0}}));
        QVERIFY(largestDifference(valuesOf(before), valuesOf(*m_document->track(kEmission))) <= 3e-6F);
    }

    void aKeyThatIsAddedToALineOrALevelStaysSmooth()
    {
        setTracks({trackOf(kEmission, {{0.0, 1.0F}, {2.0, 3.0F}})});
        doubleClickOnTheCurve(20);
        for (const KeyFrame& key : m_document->track(kEmission)->keys) {
            QCOMPARE(key.ease, Ease::Auto); // the line needs no slopes of its own
        }
        setTracks({trackOf(kEmission, {{0.0, 1.0F}, {1.0, 1.0F}})});
        doubleClickOnTheCurve(60);
        QCOMPARE(m_document->track(kEmission)->keys.size(), std::size_t{3});
        QVERIFY(m_document->track(kEmission)->isConstant());
    }

    void aKeyThatIsAddedToWhatRepeatsLandsAmongTheKeys()
    {
        Track before = trackOf(kEmission, {{0.0, 1.0F}, {0.5, 3.0F}, {1.0, 1.5F}});
        for (const Extrapolation after : {Extrapolation::Loop, Extrapolation::PingPong}) {
            before.after = after;
            setTracks({before});
            const std::optional<double> time = addKeyOnCurve(*m_document, kEmission, 1.75);
            QVERIFY(time);
            QCOMPARE(*time, after == Extrapolation::Loop ? 0.75 : 0.25);
            QCOMPARE(m_document->track(kEmission)->keys.size(), std::size_t{4});
            QVERIFY(largestDifference(valuesOf(before), valuesOf(*m_document->track(kEmission))) <= 3e-6F);
        }
    }

    void aHandleSetsBothSlopesAndWithCtrlOne()
    {
        setTracks({trackOf(kEmission, {{0.0, 1.0F}, {1.0, 2.0F}, {2.0, 1.0F}})});
        const KeyPlace key{&kEmission, 1.0};
        QTest::mouseClick(&graph(), Qt::LeftButton, {}, graph().placeOf(key).toPoint());
        const float out = dragHandle(key, true, {12, 30}, {});
        const KeyFrame both = m_document->track(kEmission)->keys[1];
        QCOMPARE(both.ease, Ease::Free);
        QCOMPARE(both.value, Value(2.0F));
        QVERIFY(out < 0.0F && std::abs(both.slopeOut.x - out) <= 1e-4F * std::abs(out));
        QCOMPARE(both.slopeIn, both.slopeOut);
        const float in = dragHandle(key, false, {-5, 20}, Qt::ControlModifier);
        const KeyFrame broken = m_document->track(kEmission)->keys[1];
        QVERIFY(std::abs(broken.slopeIn.x - in) <= 1e-4F * std::abs(in));
        QCOMPARE(broken.slopeOut, both.slopeOut);
        QVERIFY(broken.slopeIn != both.slopeIn);
        m_document->undoStack()->undo();
        QCOMPARE(m_document->track(kEmission)->keys[1], both);
        m_document->undoStack()->undo();
        QCOMPARE(m_document->track(kEmission)->keys[1], (KeyFrame{1.0, 2.0F}));
    }

    void handlesBeginWithTheSlopesThatTheCurveHas()
    {
        const Track track = trackOf(kEmission, {{0.0, 1.0F}, {1.0, 2.0F}, {2.0, 4.0F, Ease::Linear}, {4.0, 1.0F}});
        for (std::size_t key = 0; key < track.keys.size(); ++key) {
            for (const bool after : {false, true}) {
                if ((after && key + 1 == track.keys.size()) || (!after && key == 0)) {
                    continue;
                }
                constexpr double kBeside = 1e-3;
                const double time = track.keys[key].seconds;
                const double beside = time + (after ? kBeside : -kBeside);
                const double rise = static_cast<double>(std::get<float>(track.at(beside)))
                    - static_cast<double>(std::get<float>(track.at(time)));
                const double slope = static_cast<double>(slopeAtKey(track, key, after).x);
                QVERIFY2(std::abs(rise / (beside - time) - slope) < 0.02, qPrintable(QString::number(slope)));
            }
        }
        setTracks({trackOf(kEmission, {{0.0, 1.0F, Ease::Hold}, {1.0, 2.0F}, {2.0, 1.0F}})});
        QVERIFY(!graph().handleOf({&kEmission, 0.0}, true)); // what holds has no slope
        QVERIFY(!graph().handleOf({&kEmission, 1.0}, false));
        QVERIFY(graph().handleOf({&kEmission, 1.0}, true));
        QVERIFY(!graph().handleOf({&kEmission, 2.0}, true)); // nothing comes after it
    }

    void escapeTakesADragBack()
    {
        setTracks({trackOf(kEmission, {{0.0, 1.0F}, {1.0, 2.0F}, {2.0, 1.0F}})});
        const Scene before = m_document->scene();
        const KeyPlace key{&kEmission, 1.0};
        const QPoint place = graph().placeOf(key).toPoint();
        QTest::mouseClick(&graph(), Qt::LeftButton, {}, place);
        for (const QPoint from : {place, graph().handleOf(key, true).value().toPoint()}) {
            QTest::mousePress(&graph(), Qt::LeftButton, {}, from);
            moveMouse(from + QPoint(20, 30));
            QVERIFY(!(m_document->scene() == before));
            DragCancel cancel;
            QApplication::sendEvent(&graph(), &cancel);
            QVERIFY(cancel.isAccepted());
            QVERIFY(m_document->scene() == before);
            moveMouse(from + QPoint(40, 10)); // the hand goes on, and holds nothing
            QTest::mouseRelease(&graph(), Qt::LeftButton, {}, from + QPoint(40, 10));
            QVERIFY(m_document->scene() == before);
            QCOMPARE(m_bar->lanes().selected(), (std::vector<KeyPlace>{key}));
        }
    }

    void aLockedLayerKeepsItsCurves()
    {
        setTracks({trackOf(kEmission, {{0.0, 1.0F}, {1.0, 2.0F}, {2.0, 1.0F}})});
        Scene scene = m_document->scene();
        scene.layers[0].locked = true;
        m_document->replaceScene(scene, 0, QStringLiteral("Lock"));
        const QPoint from = graph().placeOf({&kEmission, 1.0}).toPoint();
        dragMouse(graph(), from, from + QPoint(30, 30));
        doubleClickOnTheCurve(12);
        QVERIFY(m_document->scene() == scene);
    }

    void arrowsMoveByAFrameAndAStepAsOneGesture()
    {
        setTracks({trackOf(kEmission, {{0.0, 1.0F}, {1.0, 2.0F}, {2.0, 1.0F}})});
        QTest::mouseClick(&graph(), Qt::LeftButton, {}, graph().placeOf({&kEmission, 1.0}).toPoint());
        const int steps = m_document->undoStack()->count();
        QTest::keyClick(&graph(), Qt::Key_Right);
        QTest::keyClick(&graph(), Qt::Key_Right);
        QTest::keyClick(&graph(), Qt::Key_Up);
        const KeyFrame& key = m_document->track(kEmission)->keys[1];
        QCOMPARE(key.seconds, 32.0 / 30.0);
        QVERIFY(std::abs(static_cast<double>(numberOf(key)) - (2.0 + kEmission.step)) < 1e-5);
        QCOMPARE(m_document->undoStack()->count(), steps + 1);
        QTest::keyClick(&graph(), Qt::Key_Delete);
        QCOMPARE(m_document->track(kEmission)->keys.size(), std::size_t{2});
    }

    void aBoxChoosesAndKeysAreCopied()
    {
        setTracks({trackOf(kEmission, {{0.5, 1.0F}, {1.0, 2.0F}, {2.0, 1.5F}})});
        const QPoint first = graph().placeOf({&kEmission, 0.5}).toPoint();
        const QPoint second = graph().placeOf({&kEmission, 1.0}).toPoint();
        dragMouse(graph(), QPoint(first.x() - 9, graph().height() - 1), QPoint(second.x() + 9, 1));
        QCOMPARE(m_bar->lanes().selected().size(), std::size_t{2}); // lanes and graph have one selection
        m_player->setFrame(90);
        QTest::keyClick(&graph(), Qt::Key_C, Qt::ControlModifier);
        QTest::keyClick(&graph(), Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(m_document->track(kEmission)->keys.size(), std::size_t{5});
        QCOMPARE(m_bar->lanes().selected().size(), std::size_t{2});
    }

    void theAxisFitsTheTrackThatIsChosen()
    {
        setTracks({trackOf(kRate, {{0.0, 0.0F}, {1.0, 1.0F}}), trackOf(kEmission, {{0.0, 20.0F}, {1.0, 40.0F}})});
        QCOMPARE(graph().curves().front().parameter, &kRate); // the first, where none is chosen
        KeyLanes& lanes = m_bar->lanes();
        const QPoint lane = lanes.placeOf({&kEmission, 1.0}).toPoint() + QPoint(60, 0);
        QTest::mouseClick(&lanes, Qt::LeftButton, {}, lane);
        QCOMPARE(graph().curves().front().parameter, &kEmission);
        QVERIFY(graph().axis().low < 20.0 && graph().axis().low > 10.0);
        QVERIFY(graph().axis().high > 40.0 && graph().axis().high < 50.0);
        // The wheel zooms about the hand.
        const ValueAxis before = graph().axis();
        const double middle = before.valueAt(QRectF(graph().rect()).center().y());
        turnWheel(graph(), 3);
        QVERIFY(graph().axis().high - graph().axis().low < 0.7 * (before.high - before.low));
        QVERIFY(std::abs(graph().axis().valueAt(QRectF(graph().rect()).center().y()) - middle) < 1e-9);
        // The middle button moves it.
        const double low = graph().axis().low;
        dragMouse(graph(), {300, 40}, {300, 60}, Qt::MiddleButton);
        QVERIFY(std::abs(graph().axis().low - low - 20.0 * graph().axis().perPixel()) < 1e-9);
        graph().setFocus();
        QTest::keyClick(&graph(), Qt::Key_F);
        QCOMPARE(graph().axis().low, before.low);
        QCOMPARE(graph().axis().high, before.high);
        // Ctrl shows another curve too.
        QTest::mouseClick(&lanes, Qt::LeftButton, Qt::ControlModifier, lane - QPoint(0, KeyLanes::kLaneHeight));
        QCOMPARE(graph().curves().size(), std::size_t{2});
    }

    void easesInAndOutAreLevelOnTheirSides()
    {
        setTracks({trackOf(kEmission, {{0.0, 1.0F}, {1.0, 2.0F, Ease::Linear}, {2.0, 4.0F}})});
        const std::vector<KeyPlace> key{{&kEmission, 1.0}};
        const float slope = slopeAtKey(*m_document->track(kEmission), 1, true).x;
        QCOMPARE(slope, 2.0F);
        setLevel(*m_document, key, true, false);
        const KeyFrame in = m_document->track(kEmission)->keys[1];
        QCOMPARE(in.ease, Ease::Free);
        QCOMPARE(in.slopeIn.x, 0.0F);
        QCOMPARE(in.slopeOut.x, slope);
        setLevel(*m_document, key, true, true);
        QCOMPARE(m_document->track(kEmission)->keys[1].slopeOut.x, 0.0F);
        // Free begins with the slopes that are there, so that the curve stays.
        setTracks({trackOf(kEmission, {{0.0, 1.0F}, {1.0, 2.0F}, {2.0, 4.0F}})});
        const std::vector<float> before = valuesOf(*m_document->track(kEmission));
        setEase(*m_document, key, Ease::Free);
        QCOMPARE(m_document->track(kEmission)->keys[1].ease, Ease::Free);
        QVERIFY(largestDifference(before, valuesOf(*m_document->track(kEmission))) <= 3e-6F);
    }

    void ticksAreOneTwoOrFive()
    {
        for (double wanted = 1e-6; wanted < 1e7; wanted *= 1.37) {
            const double step = roundStep(wanted);
            const double lead = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
            QVERIFY2(std::abs(lead - 1.0) < 1e-9 || std::abs(lead - 2.0) < 1e-9 || std::abs(lead - 5.0) < 1e-9,
                qPrintable(QString::number(step)));
            QVERIFY(step >= wanted * (1.0 - 1e-9) && step <= 2.5 * wanted);
        }
        QCOMPARE(roundStep(1000.0), 1000.0);
        QCOMPARE(roundTicks(-1.0, 1.0, 0.5), (std::vector<double>{-1.0, -0.5, 0.0, 0.5, 1.0}));
        QCOMPARE(roundTicks(0.3, 0.9, 1.0), std::vector<double>{});
        QCOMPARE(tickText(3.0 * 0.1, 0.1, Unit::None), formatNumber(0.3));
        QCOMPARE(tickText(1000.0005, 0.0005, Unit::None), formatNumber(1000.0005, 8));
        QCOMPARE(tickText(15.0, 5.0, Unit::Metres), formatNumber(15.0, Unit::Metres));
        const ValueAxis axis{0.0, 3.0, 150.0, 10.0};
        QCOMPARE(axis.tickStep(), 1.0); // 28 pixels are 0.6
        QCOMPARE(axis.valueAt(axis.yOf(1.25)), 1.25);
    }

    void onlyWhatIsAnimatedIsShown()
    {
        Locks locks;
        Solo solo(*m_document);
        EffectPanel panel(*m_document, locks, solo);
        panel.resize(400, 900);
        panel.show();
        panel.findChild<QToolButton*>(u"onlyAnimated"_q)->click();
        const auto* nothing = panel.findChild<QLabel*>(u"parameterSearch.nothing"_q);
        QVERIFY(nothing->isVisible() && nothing->text().contains(u"key frames"_q));
        QVERIFY(shownRows(panel).empty());
        // Of a layer, of the scene, and one that has no effect as the smoke stands.
        const Parameter& yaw = knownParameter("camera.yaw");
        const Parameter& width = knownParameter("emitter.width"); // of a disc
        setTracks({trackOf(kRate, {{0.0, 0.0F}, {1.0, 1.0F}}), trackOf(yaw, {{0.0, 10.0F}}),
            trackOf(width, {{0.0, 1.0F}, {1.0, 2.0F}})});
        std::vector<const Parameter*> wanted{&kRate, &yaw, &width};
        std::sort(wanted.begin(), wanted.end());
        QCOMPARE(shownRows(panel), wanted);
        QVERIFY(!nothing->isVisible());
        removeAllKeys(*m_document, yaw);
        std::erase(wanted, &yaw);
        QCOMPARE(shownRows(panel), wanted);
        panel.findChild<QToolButton*>(u"onlyAnimated"_q)->click();
        QVERIFY(shownRows(panel).size() > wanted.size());
    }

protected:
    void prepare(TimelineBar& bar) override
    {
        bar.setShowsGraph(true);
        bar.resize(900, 400);
    }

private:
    [[nodiscard]] KeyGraph& graph() const { return m_bar->graph(); }
    [[nodiscard]] int framesWide(int frames) const
    {
        return static_cast<int>(std::lround(frames * (m_bar->ruler().xOf(1.0) - m_bar->ruler().xOf(0.0))));
    }
    void moveMouse(QPoint to)
    {
        QMouseEvent event(QEvent::MouseMove, to, graph().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&graph(), &event);
    }
    void doubleClickOnTheCurve(int frame)
    {
        const double value = static_cast<double>(std::get<float>(m_document->track(kEmission)->at(frame / 30.0)));
        const QPointF place(m_bar->ruler().xOf(frame), graph().axis().yOf(value));
        QTest::mouseDClick(&graph(), Qt::LeftButton, {}, place.toPoint());
    }
    /// @return the slope that the end of the handle shows where it was dragged to
    float dragHandle(const KeyPlace& key, bool after, QPoint way, Qt::KeyboardModifiers modifiers)
    {
        const QPointF end = graph().handleOf(key, after).value();
        const QPointF arm = end + way - graph().placeOf(key);
        const double perSecond = (m_bar->ruler().xOf(1.0) - m_bar->ruler().xOf(0.0)) * 30.0;
        const double perPixel = graph().axis().perPixel(); // the axis may be fitted again afterwards
        dragMouse(graph(), end.toPoint(), end.toPoint() + way, Qt::LeftButton, modifiers);
        return static_cast<float>(-arm.y() * perPixel / arm.x() * perSecond);
    }
    /// The parameters whose rows can be seen in a panel, one for each row, by their addresses.
    static std::vector<const Parameter*> shownRows(const EffectPanel& panel)
    {
        std::vector<const Parameter*> shown;
        for (const ParameterRow* row : panel.findChildren<ParameterRow*>()) {
            if (row->isVisibleTo(&panel)) {
                shown.push_back(&row->parameter());
            }
        }
        std::sort(shown.begin(), shown.end());
        return shown;
    }
};

FUMAGE_TEST_MAIN(KeyGraphTest)
#include "key_graph_test.moc"
