// Key frames in the editor: diamonds, edits at the time that is shown, lanes under the ruler, each gesture one undo
// step.

#include "timeline_fixture.h"

#include "ui/document/locks.h"
#include "ui/panels/key_mark.h"
#include "ui/panels/parameter_row.h"
#include "ui/timeline/key_clipboard.h"
#include "ui/timeline/key_mends.h"
#include "ui/widgets/gesture.h"

#include "core/effect/known_parameter.h"

#include <QClipboard>
#include <QMenu>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr const Parameter& kRate = knownParameter("emitter.rate");
constexpr const Parameter& kEmission = knownParameter("glow.emission");

Track trackOf(const Parameter& parameter, std::vector<KeyFrame> keys)
{
    return {&parameter, std::move(keys)};
}

float shown(const Document& document, const Parameter& parameter)
{
    return std::get<float>(parameter.get(document.effect()));
}

std::vector<double> timesOf(const Document& document, const Parameter& parameter)
{
    std::vector<double> times;
    if (const Track* track = document.track(parameter)) {
        for (const KeyFrame& key : track->keys) {
            times.push_back(key.seconds);
        }
    }
    return times;
}

} // namespace

class KeyFramesTest : public TimelineFixture {
    Q_OBJECT

private slots:
    void anEditOfWhatHasKeysSetsOneAtTheTimeThatIsShown()
    {
        const Scene before = m_document->scene();
        m_document->edit(kRate, 0.5F);
        QVERIFY(m_document->track(kRate) == nullptr); // without keys it is the value, as ever
        addKey(*m_document, kRate);
        m_player->setFrame(30);
        m_document->edit(kRate, 1.0F);
        QCOMPARE(timesOf(*m_document, kRate), (std::vector<double>{0.0, 1.0}));
        m_player->setFrame(15);
        QCOMPARE(shown(*m_document, kRate), 0.75F);
        m_document->edit(kRate, 0.2F);
        QCOMPARE(timesOf(*m_document, kRate), (std::vector<double>{0.0, 0.5, 1.0}));
        m_document->edit(kRate, 0.3F); // the key that is there gets the value
        QCOMPARE(timesOf(*m_document, kRate).size(), std::size_t{3});
        QCOMPARE(shown(*m_document, kRate), 0.3F);
        while (m_document->undoStack()->canUndo()) {
            m_document->undoStack()->undo();
        }
        QVERIFY(m_document->scene() == before);
    }

    void autoKeyMakesTheFirstOneToo()
    {
        m_player->setFrame(12);
        m_document->setAutoKey(true);
        m_document->edit(kEmission, 2.0F);
        QCOMPARE(timesOf(*m_document, kEmission), (std::vector<double>{0.4}));
        m_document->edit(knownParameter("emitter.seed"), 5U); // what cannot change over time is just set
        QVERIFY(m_document->track(knownParameter("emitter.seed")) == nullptr);
        QCOMPARE(m_document->effect().emitter.seed, 5U);
    }

    void aDragIsOneStep()
    {
        addKey(*m_document, kRate);
        const int steps = m_document->undoStack()->count();
        const Gesture gesture = m_document->beginGesture();
        for (int i = 1; i <= 20; ++i) {
            m_document->edit(kRate, 1.0F - 0.02F * static_cast<float>(i), gesture);
        }
        QCOMPARE(m_document->undoStack()->count(), steps + 1);
        m_document->undoStack()->undo();
        QCOMPARE(shown(*m_document, kRate), 1.0F);
    }

    void theDiamondPutsAKeyAndTakesIt()
    {
        Locks locks;
        ParameterRow row(kEmission, *m_document, locks, nullptr);
        connect(m_document.get(), &Document::effectChanged, &row, &ParameterRow::sync);
        row.resize(400, 30);
        row.show();
        row.sync();
        auto* mark = row.findChild<KeyMark*>();
        QVERIFY(mark != nullptr);
        QCOMPARE(mark->state(), KeyState::None);
        QTest::mouseClick(mark, Qt::LeftButton);
        QCOMPARE(mark->state(), KeyState::Here);
        m_player->setFrame(3);
        QCOMPARE(mark->state(), KeyState::Animated);
        QTest::mouseClick(mark, Qt::LeftButton);
        QCOMPARE(timesOf(*m_document, kEmission).size(), std::size_t{2});
        QTest::mouseClick(mark, Qt::LeftButton);
        m_player->setFrame(0);
        QTest::mouseClick(mark, Qt::LeftButton);
        QCOMPARE(mark->state(), KeyState::None); // with the last one the parameter is as it was shown
        QVERIFY(m_document->scene().layers[0].tracks.empty());
    }

    void whatCannotChangeHasNoDiamond()
    {
        Locks locks;
        for (const Parameter& parameter : parameterTable()) {
            ParameterRow row(parameter, *m_document, locks, nullptr);
            QCOMPARE(row.findChild<KeyMark*>() != nullptr, canAnimate(parameter));
        }
    }

    void keysAreDraggedByFrames()
    {
        setTracks({trackOf(kRate, {{0.0, 0.0F}, {1.0, 1.0F}, {2.0, 0.0F}})});
        const int steps = m_document->undoStack()->count();
        drag({&kRate, 1.0}, 9);
        QCOMPARE(timesOf(*m_document, kRate), (std::vector<double>{0.0, 1.3, 2.0}));
        QCOMPARE(m_document->undoStack()->count(), steps + 1);
        drag({&kRate, 0.0}, -50); // none gets before the beginning
        QCOMPARE(timesOf(*m_document, kRate).front(), 0.0);
        m_document->undoStack()->undo();
        QCOMPARE(timesOf(*m_document, kRate), (std::vector<double>{0.0, 1.0, 2.0}));
    }

    void aBoxChoosesAndAltStretches()
    {
        setTracks(
            {trackOf(kRate, {{0.5, 0.0F}, {1.0, 1.0F}, {1.5, 0.0F}}), trackOf(kEmission, {{1.0, 1.0F}, {4.0, 2.0F}})});
        KeyLanes& lanes = m_bar->lanes();
        const QPoint first = lanes.placeOf({&kRate, 0.5}).toPoint();
        const QPoint last = lanes.placeOf({&kEmission, 1.0}).toPoint();
        dragMouse(lanes, first - QPoint(8, 6), QPoint(lanes.placeOf({&kRate, 1.5}).toPoint().x() + 8, last.y() + 6));
        QCOMPARE(lanes.selected().size(), std::size_t{4});
        // Twice as far from the first: .5, 1, 1.5 become .5, 1.5, 2.5.
        drag({&kRate, 1.5}, 30, Qt::AltModifier);
        QCOMPARE(timesOf(*m_document, kRate), (std::vector<double>{0.5, 1.5, 2.5}));
        QCOMPARE(timesOf(*m_document, kEmission), (std::vector<double>{1.5, 4.0}));
        QTest::keyClick(&lanes, Qt::Key_Delete);
        QVERIFY(m_document->track(kRate) == nullptr);
        QCOMPARE(timesOf(*m_document, kEmission), (std::vector<double>{4.0}));
    }

    void keysArePastedAtTheTimeThatIsShown()
    {
        setTracks({trackOf(kRate, {{0.5, 0.0F, Ease::Hold}, {1.0, 1.0F}})});
        copyKeys(*m_document, {{&kRate, 0.5}, {&kRate, 1.0}});
        QVERIFY(hasCopiedKeys());
        m_player->setFrame(60);
        QCOMPARE(pasteKeys(*m_document).size(), std::size_t{2});
        QCOMPARE(timesOf(*m_document, kRate), (std::vector<double>{0.5, 1.0, 2.0, 2.5}));
        QCOMPARE(m_document->track(kRate)->keys[2].ease, Ease::Hold);
        // To another layer, too.
        Scene scene = m_document->scene();
        scene.layers.emplace_back();
        m_document->replaceScene(scene, 1, QStringLiteral("Add"));
        QCOMPARE(pasteKeys(*m_document).size(), std::size_t{2});
        QCOMPARE(timesOf(*m_document, kRate), (std::vector<double>{2.0, 2.5}));
        QCOMPARE(m_document->scene().layers[0].tracks.find(kRate)->keys.size(), std::size_t{4});
        QApplication::clipboard()->setText(QStringLiteral("no keys"));
        QVERIFY(!hasCopiedKeys());
        QVERIFY(pasteKeys(*m_document).empty());
    }

    void escapeTakesBackTheKeyThatADragHasSet_data()
    {
        QTest::addColumn<bool>("autoKey");
        QTest::newRow("with auto-key") << true;
        QTest::newRow("between key frames") << false;
    }
    void escapeTakesBackTheKeyThatADragHasSet()
    {
        QFETCH(bool, autoKey);
        if (!autoKey) {
            setTracks({trackOf(kRate, {{0.0, 0.0F}, {2.0, 1.0F}})});
        }
        m_player->setFrame(30);
        m_document->setAutoKey(autoKey);
        const Scene before = m_document->scene();
        const int steps = m_document->undoStack()->count();
        Locks locks;
        ParameterRow row(kRate, *m_document, locks, nullptr);
        emit row.editor().edited(0.7F, false);
        QCOMPARE(timesOf(*m_document, kRate).size(), autoKey ? std::size_t{1} : std::size_t{3});
        DragCancel cancel;
        QApplication::sendEvent(&row, &cancel);
        QVERIFY(cancel.isAccepted());
        emit row.editor().edited(0.8F, true); // the release
        QVERIFY(m_document->scene() == before);
        QCOMPARE(m_document->undoStack()->count(), steps);
        emit row.editor().edited(0.9F, true); // the next gesture is one again
        QCOMPARE(m_document->undoStack()->count(), steps + 1);
    }

    void escapeInABoxOfTheLanesSelectsWhatWasSelected()
    {
        setTracks({trackOf(kRate, {{0.5, 0.0F}, {1.0, 1.0F}, {1.5, 0.0F}})});
        KeyLanes& lanes = m_bar->lanes();
        const QPoint first = lanes.placeOf({&kRate, 0.5}).toPoint();
        QTest::mouseClick(&lanes, Qt::LeftButton, {}, first);
        const std::vector<KeyPlace> before = lanes.selected();
        QCOMPARE(before.size(), std::size_t{1});
        const QPoint from = lanes.placeOf({&kRate, 1.0}).toPoint() - QPoint(12, 6);
        const QPoint to = lanes.placeOf({&kRate, 1.5}).toPoint() + QPoint(12, 6);
        QTest::mousePress(&lanes, Qt::LeftButton, {}, from);
        QMouseEvent move(QEvent::MouseMove, to, lanes.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&lanes, &move);
        QCOMPARE(lanes.selected().size(), std::size_t{2});
        DragCancel cancel;
        QApplication::sendEvent(&lanes, &cancel);
        QVERIFY(cancel.isAccepted());
        QTest::mouseRelease(&lanes, Qt::LeftButton, {}, to);
        QVERIFY(lanes.selected() == before);
    }

    void aLockedLayerKeepsItsKeys()
    {
        setTracks({trackOf(kRate, {{0.0, 0.0F}, {1.0, 1.0F}})});
        Scene scene = m_document->scene();
        scene.layers[0].locked = true;
        m_document->replaceScene(scene, 0, QStringLiteral("Lock"));
        m_document->edit(kRate, 0.5F);
        addKey(*m_document, kRate);
        removeAllKeys(*m_document, kRate);
        drag({&kRate, 1.0}, 5);
        m_document->reset(kRate);
        QVERIFY(m_document->scene() == scene);
    }

    void resetBringsKeysBack()
    {
        Preset preset;
        preset.scene.layers[0].tracks.set(trackOf(kRate, {{0.0, 0.0F}, {1.0, 1.0F}}));
        m_document->load(preset, {});
        removeAllKeys(*m_document, kRate);
        QVERIFY(m_document->track(kRate) == nullptr);
        m_document->reset(kRate);
        QVERIFY(m_document->scene() == preset.scene);
        addKey(*m_document, kEmission);
        m_document->reset(kEmission);
        QVERIFY(m_document->scene() == preset.scene);
    }

    void severalAreResetWithTheirKeysInOneStep()
    {
        Preset preset;
        preset.scene.layers[0].tracks.set(trackOf(kRate, {{0.0, 0.0F}, {1.0, 1.0F}}));
        m_document->load(preset, {});
        Locks locks;
        ParameterRow row(kEmission, *m_document, locks, nullptr);
        row.sync();
        QVERIFY(!row.isChanged());
        addKey(*m_document, kEmission); // of the value that it has: it differs all the same
        row.sync();
        QVERIFY(row.isChanged() && differsFromReference(*m_document, kEmission));
        removeAllKeys(*m_document, kRate);
        m_document->edit(knownParameter("motion.gravity"), 3.0F);
        const int steps = m_document->undoStack()->count();
        resetParameters(*m_document, {&kEmission, &kRate, &knownParameter("motion.gravity")}, QStringLiteral("Reset"));
        QVERIFY(m_document->scene() == preset.scene);
        QCOMPARE(m_document->undoStack()->count(), steps + 1);
        row.sync();
        QVERIFY(!row.isChanged());
    }

    void aCameraWithKeysIsMovedByKeys()
    {
        const Parameter& yaw = knownParameter("camera.yaw");
        addKey(*m_document, yaw);
        m_player->setFrame(30);
        Camera turned = m_document->effect().camera;
        turned.yaw += 40.0F;
        turned.distance += 1.0F;
        m_document->moveCamera(turned);
        QCOMPARE(timesOf(*m_document, yaw), (std::vector<double>{0.0, 1.0}));
        QVERIFY(m_document->track(knownParameter("camera.distance")) == nullptr);
        QCOMPARE(m_document->effect().camera.distance, turned.distance);
        QCOMPARE(m_document->effect().camera.yaw, turned.yaw);
    }

    void faultsAreShownInTheirLaneAndMendedByItsMenu()
    {
        const Timeline timeline = m_document->scene().timeline;
        const double length = static_cast<double>(timeline.length) / timeline.frameRate;
        const Track late = trackOf(kRate, {{0.0, 0.0F}, {2.0 * length, 1.0F}});
        QVERIFY(keyFaultsTold(trackOf(kRate, {{0.0, 0.0F}, {0.5 * length, 0.0F}}), timeline).isEmpty());
        QVERIFY(keyFaultsTold(late, timeline).contains(QLatin1String("after the end")));
        setTracks({late});
        QMenu menu;
        addKeyMends(menu, *m_document, *m_document->track(kRate));
        const int steps = m_document->undoStack()->count();
        for (QAction* action : menu.actions()) {
            action->trigger();
        }
        QVERIFY(keyFaults(*m_document->track(kRate), timeline).empty());
        QVERIFY(m_document->undoStack()->count() > steps);
        m_document->undoStack()->setIndex(steps);
        QVERIFY(*m_document->track(kRate) == late);
        // All at once, in one step.
        mendKeys(*m_document);
        QVERIFY(!hasKeyFaults(m_document->scene()));
        QCOMPARE(m_document->undoStack()->count(), steps + 1);
    }

    /// As many as the schedule says; a layer that emits all the time has none while it is alone.
    void stripsShowWhenLayersEmit()
    {
        EmissionStrip& strip = m_bar->emission();
        QVERIFY(strip.strips().empty() && !strip.isVisible());
        setTracks({trackOf(kRate, {{0.0, 0.0F}, {1.0, 1.0F}})});
        QCOMPARE(strip.strips().size(), std::size_t{1});
        QVERIFY(strip.isVisible());
        const std::vector<float>& shares = strip.strips().front().shares;
        QCOMPARE(shares.size(), static_cast<std::size_t>(m_document->scene().timeline.length));
        QVERIFY(shares.front() < 0.1F && shares[15] > 0.4F && shares[15] < 0.6F && shares[40] > 0.95F);
        Scene scene = m_document->scene();
        scene.layers.resize(3);
        scene.layers[1].emitter.start = 1.0F;
        scene.layers[1].emitter.length = 0.5F;
        scene.layers[2].visible = false;
        m_document->replaceScene(scene, 0, QStringLiteral("Add"));
        QCOMPARE(strip.strips().size(), std::size_t{2});
        const std::vector<float>& late = strip.strips()[1].shares;
        for (int frame = 0; frame < 60; ++frame) {
            const bool emits = frame > 31 && frame < 44;
            const bool isNear = std::abs(frame - 31) <= 1 || std::abs(frame - 45) <= 1;
            QVERIFY2(
                isNear || (late[static_cast<std::size_t>(frame)] > 0.0F) == emits, qPrintable(QString::number(frame)));
        }
        QTest::mouseClick(&strip, Qt::LeftButton, {}, QPoint(100, EmissionStrip::kStripHeight + 2));
        QCOMPARE(m_document->layer(), std::size_t{1});
    }

    void lanesTakeNoRoomWhereNothingChanges()
    {
        QVERIFY(!m_bar->findChild<QWidget*>(QStringLiteral("keyLanesView"))->isVisible());
        setTracks({trackOf(kRate, {{0.0, 0.0F}, {1.0, 1.0F}})});
        QTRY_VERIFY(m_bar->findChild<QWidget*>(QStringLiteral("keyLanesView"))->isVisible());
        QCOMPARE(m_bar->lanes().height(), KeyLanes::kLaneHeight);
    }

private:
    void drag(const KeyPlace& key, int frames, Qt::KeyboardModifiers modifiers = {})
    {
        KeyLanes& lanes = m_bar->lanes();
        const QPoint from = lanes.placeOf(key).toPoint();
        const double perFrame = m_bar->ruler().xOf(1.0) - m_bar->ruler().xOf(0.0);
        dragMouse(
            lanes, from, from + QPoint(static_cast<int>(std::lround(frames * perFrame)), 0), Qt::LeftButton, modifiers);
    }
};

FUMAGE_TEST_MAIN(KeyFramesTest)
#include "key_frames_test.moc"
