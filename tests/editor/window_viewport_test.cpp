// The viewport in its window, with the mouse.
#include "window_fixture.h"

#include "ui/panels/effect_panel.h"
#include "ui/panels/number_field.h"
#include "ui/viewport/gizmos.h"
#include "ui/viewport/viewport.h"

#include "core/effect/known_parameter.h"

#include <QClipboard>
#include <QColorDialog>
#include <QMenu>
#include <QToolButton>

using namespace fumage;
using namespace fumage::tests;

class WindowViewportTest : public WindowFixture {
    Q_OBJECT

private slots:
    void handlesComeWithTheMouseAndTheAirBoxWhenItIsTouched()
    {
        Document& document = m_window->document();
        document.edit(knownParameter("air.enabled"), true);
        document.edit(knownParameter("air.fit"), false);
        document.edit(knownParameter("air.resolution"), 16);
        (void)settled();
        trigger("view.readout"); // its figures change
        QWidget& surface = *m_window->viewport().surface();
        const auto seen = [&](QEvent::Type mouse) {
            if (mouse == QEvent::Leave) {
                QEvent leave(QEvent::Leave);
                QApplication::sendEvent(&surface, &leave);
            } else {
                QEnterEvent enter(QPointF(3, 3), QPointF(3, 3), surface.mapToGlobal(QPointF(3, 3)));
                QApplication::sendEvent(&surface, &enter);
            }
            return surface.grab().toImage();
        };
        const QImage away = seen(QEvent::Leave);
        const QImage near = seen(QEvent::Enter);
        QVERIFY(away != near);
        trigger("view.gizmos");
        QCOMPARE(seen(QEvent::Enter), away);
        QCOMPARE(seen(QEvent::Leave), away);
    }

    void soloShowsItsLayerAloneAndSaysSo()
    {
        Document& document = m_window->document();
        Scene scene = document.scene();
        scene.layers.push_back(scene.layers[0]);
        scene.layers[0].name = "<b>one</b>";
        scene.layers[0].emitter.position.x = -1.2F;
        scene.layers[1].emitter.position.x = 1.2F;
        document.replaceScene(scene, 0, u"two"_q);
        const QImage both = settled();
        const auto* line = m_window->findChild<SoloLine*>(u"soloLine"_q);
        QVERIFY(line->isHidden());
        m_window->solo().set({0}, true);
        QVERIFY(line->isVisible());
        QVERIFY2(line->text().contains(u"<b>one</b>"_q), qPrintable(line->text()));
        const QImage one = settled();
        QVERIFY(one != both);
        trigger("view.smokeOnly");
        QVERIFY(line->isHidden());
        trigger("view.smokeOnly");
        QVERIFY(line->isVisible());
        m_window->findChild<QToolButton*>(u"soloLine.end"_q)->click();
        QVERIFY(line->isHidden() && !m_window->solo().isOn());
        QVERIFY(!settled().isNull());
        m_window->solo().set({1}, true);
        document.load(smallPreset(), {});
        QVERIFY(line->isHidden() && !m_window->solo().isOn());
    }

    void aClickOnSmokeOrOnAnOutlineEditsItsLayer()
    {
        Document& document = m_window->document();
        Scene scene = document.scene();
        scene.layers.push_back(scene.layers[0]);
        scene.layers[0].emitter.position.x = -1.2F;
        scene.layers[1].emitter.position.x = 1.2F;
        scene.layers[1].emitter.seed = 5;
        scene.camera.distance = 8.0F;
        document.replaceScene(scene, 0, u"two"_q);
        QVERIFY(!settled().isNull());
        const int steps = document.undoStack()->count();
        const Camera camera = document.effect().camera;
        Viewport& viewport = m_window->viewport();
        const auto click = [&](const glm::vec3& place, Qt::KeyboardModifiers modifiers = {}) {
            const Projected at = project(viewport.view(), place);
            QTest::mouseClick(viewport.surface(), Qt::LeftButton, modifiers,
                QPoint(static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y))));
        };
        trigger("view.emitter"); // the smoke alone
        click({1.2F, 0.3F, 0.0F});
        QTRY_COMPARE(document.layer(), std::size_t{1});
        click({-1.2F, 0.3F, 0.0F});
        QTRY_COMPARE(document.layer(), std::size_t{0});
        click({1.2F, 0.3F, 0.0F}, Qt::ControlModifier);
        QTRY_COMPARE(document.selection(), LayerSelection(1, {0}));
        trigger("view.emitter");
        const QPointF onIt = emitterOutline(document.scene().layers[0].emitter, viewport.view()).front().center();
        QTest::mouseClick(viewport.surface(), Qt::LeftButton, {}, onIt.toPoint());
        QCOMPARE(document.selection(), LayerSelection(0));
        // Neither a step nor another view; a drag is none of it.
        QCOMPARE(document.undoStack()->count(), steps);
        QVERIFY(document.effect().camera == camera);
        const Projected at = project(viewport.view(), {1.2F, 0.3F, 0.0F});
        const QPoint from(static_cast<int>(at.x), static_cast<int>(at.y));
        dragMouse(*viewport.surface(), from, from + QPoint(30, 10));
        QVERIFY(!settled().isNull());
        QCOMPARE(document.layer(), std::size_t{0});
        QVERIFY(!(document.effect().camera == camera));
    }

    void theRightButtonOpensAMenuUnlessItDrags()
    {
        QWidget& surface = *m_window->viewport().surface();
        const QPoint at(40, 40);
        const auto menu = [&] { return m_window->findChild<QMenu*>(u"viewportMenu"_q); };
        QTest::mouseClick(&surface, Qt::RightButton, {}, at);
        QVERIFY(menu() != nullptr);
        QStringList offered;
        for (const QAction* action : menu()->actions()) {
            offered += action->objectName();
        }
        for (const char* id :
            {"view.frameAll", "view.front", "view.grid", "view.gizmos", "view.resetCamera", "view.copyFrame"}) {
            QVERIFY2(offered.contains(QString::fromLatin1(id)), id);
        }
        delete menu();
        m_window->viewport().setNavigationStyle(NavigationStyle::Unity);
        dragMouse(surface, at, at + QPoint(60, 20), Qt::RightButton);
        QVERIFY(menu() == nullptr);
    }

    void thePictureIsCopiedAndTheCameraReset()
    {
        const Camera before = m_window->document().effect().camera;
        trigger("view.right");
        QVERIFY(!(m_window->document().effect().camera == before));
        trigger("view.resetCamera");
        QVERIFY(m_window->document().effect().camera == before);
        const QImage picture = settled();
        trigger("view.copyFrame");
        QCOMPARE(QGuiApplication::clipboard()->image().size(), picture.size());
    }

    void theWindArrowIsDragged()
    {
        Viewport& viewport = m_window->viewport();
        m_window->document().edit(knownParameter("camera.pitch"), 35.0F);
        const QImage before = settled();
        const QPoint from = handleOnScreen(GizmoId::Wind);
        const int steps = m_window->document().undoStack()->count();
        dragMouse(*viewport.surface(), from, from + QPoint(-60, 50));
        QVERIFY(m_window->document().effect().wind.angle != 0.0F);
        QCOMPARE(m_window->document().undoStack()->count(), steps + 1);
        QVERIFY(settled() != before);
        trigger("edit.undo");
        QCOMPARE(m_window->document().effect().wind.angle, 0.0F);
        QCOMPARE(settled(), before);
    }

    void theEmitterNormalIsDraggedAndThePanelFollows()
    {
        auto* panel = m_window->findChild<EffectPanel*>();
        auto* x = panel->findChild<NumberField*>(u"emitter.normal.x"_q);
        const QPoint from = handleOnScreen(GizmoId::EmitterNormal);
        dragMouse(*m_window->viewport().surface(), from, from + QPoint(40, 20));
        QVERIFY(m_window->document().effect().emitter.normal.x > 0.2F);
        QCOMPARE(
            x->value(), std::round(static_cast<double>(m_window->document().effect().emitter.normal.x) * 1e4) / 1e4);
        QCOMPARE(m_window->document().undoStack()->count(), 1);
    }

    void theCameraOrbitsPansAndZooms()
    {
        QWidget& surface = *m_window->viewport().surface();
        const QPoint corner(30, 30);
        const Camera before = m_window->document().effect().camera;
        dragMouse(surface, corner, corner + QPoint(80, 40), Qt::MiddleButton);
        QVERIFY(m_window->document().effect().camera.yaw != before.yaw);
        dragMouse(surface, corner, corner + QPoint(80, 40), Qt::MiddleButton, Qt::ShiftModifier);
        QVERIFY(!(m_window->document().effect().camera.target == before.target));
        turnWheel(surface, 2);
        turnWheel(surface, 1);
        QVERIFY(m_window->document().effect().camera.distance < before.distance);
        QCOMPARE(m_window->document().undoStack()->count(), 0);
        QVERIFY(m_window->isWindowModified()); // it is saved with the document
        trigger("view.front");
        QCOMPARE(m_window->document().effect().camera.yaw, 0.0F);
        for (int view = 0; view < 4; ++view) { // front, one burst of the wheel, pan, orbit
            QVERIFY(m_window->actions().get("view.previous").isEnabled());
            trigger("view.previous");
        }
        QVERIFY(m_window->document().effect().camera == before);
        QVERIFY(!m_window->actions().get("view.previous").isEnabled() && !m_window->isWindowModified());
        trigger("view.next");
        QVERIFY(m_window->document().effect().camera.yaw != before.yaw);
    }

    void undoingNeverThrowsTheCameraAway()
    {
        Document& document = m_window->document();
        document.edit(knownParameter("motion.gravity"), 3.0F);
        Effect other = document.effect();
        other.wind.strength = 2.0F;
        document.replaceEffect(other, u"Randomise"_q);
        trigger("view.right");
        const Camera seen = document.effect().camera;
        while (document.undoStack()->canUndo()) {
            trigger("edit.undo");
            QVERIFY(document.effect().camera == seen);
        }
        QCOMPARE(document.effect().wind.strength, smallPreset().scene.wind.strength);
        while (document.undoStack()->canRedo()) {
            trigger("edit.redo");
            QVERIFY(document.effect().camera == seen);
        }
        QCOMPARE(document.effect().wind.strength, 2.0F);
    }

    void aBackdropThatIsNotTakenLeavesTheCheckers()
    {
        Viewport& viewport = m_window->viewport();
        const Backdrop before = viewport.backdrop();
        trigger("view.checker");
        trigger("view.backdrop");
        auto* dialog = childOf<QColorDialog>(*m_window, u"colourDialog"_q);
        dialog->setCurrentColor(Qt::red);
        QCOMPARE(viewport.backdrop().kind, Backdrop::Kind::Colour);
        dialog->reject();
        QCOMPARE(viewport.backdrop().kind, Backdrop::Kind::Checker);
        QCOMPARE(viewport.backdrop().colour, before.colour);
        QTRY_VERIFY(m_window->findChild<QColorDialog*>() == nullptr);
        trigger("view.backdrop");
        dialog = childOf<QColorDialog>(*m_window, u"colourDialog"_q);
        dialog->setCurrentColor(Qt::red);
        dialog->accept();
        QCOMPARE(viewport.backdrop().kind, Backdrop::Kind::Colour);
        QCOMPARE(viewport.backdrop().colour, glm::vec3(1.0F, 0.0F, 0.0F));
    }

    void scrubbingBackAndForthGivesTheSamePictures()
    {
        Player& player = m_window->player();
        QHash<int, QImage> pictures;
        for (const int frame : {5, 40, 12}) {
            player.setFrame(frame);
            pictures.insert(frame, settled());
        }
        QVERIFY(pictures[5] != pictures[40]);
        // Another revision and back again, so that nothing comes out of the cache.
        m_window->document().edit(knownParameter("motion.gravity"), 2.0F);
        QVERIFY(!settled().isNull());
        trigger("edit.undo");
        for (const int frame : {12, 5, 40, 5}) {
            player.setFrame(frame);
            QCOMPARE(settled(), pictures[frame]);
        }
    }

    void theKeyboardBelongsToTheViewportAtFirst()
    {
        const QWidget* focused = m_window->focusWidget();
        QVERIFY(focused != nullptr);
        QVERIFY2(m_window->centralWidget()->isAncestorOf(focused), qPrintable(focused->objectName()));
    }

    void playingShowsEveryFrameAndKeepsThePictures()
    {
        Player& player = m_window->player();
        player.setRange(0, 9);
        player.setFrame(0);
        QVERIFY(!settled().isNull());
        QSet<int> shown;
        connect(&m_window->viewport(), &Viewport::pictureShown, this,
            [&](const PicturePtr& picture) { shown += picture->frame; });
        QTest::keyClick(m_window, Qt::Key_Space);
        QVERIFY(player.isPlaying());
        QTRY_COMPARE(shown.size(), 10);
        QTest::keyClick(m_window, Qt::Key_Space);
        QVERIFY(!player.isPlaying());
        QVERIFY(m_window->viewport().cachedFrames().size() >= 10);
    }

    void aHiddenWindowDoesNotWork()
    {
        m_window->player().play();
        QTRY_VERIFY(m_window->player().frame() != 30);
        m_window->hide();
        const int frame = m_window->player().frame();
        // Many turns of the event loop, in which a player that ran would have gone on.
        QTimer timer;
        QSignalSpy turns(&timer, &QTimer::timeout);
        timer.start(5);
        QTRY_VERIFY(turns.size() > 40);
        QCOMPARE(m_window->player().frame(), frame);
        m_window->show();
        QTRY_VERIFY(m_window->player().frame() != frame);
    }

private:
    QPoint handleOnScreen(GizmoId id)
    {
        const View view = m_window->viewport().view();
        for (const Gizmo& gizmo : gizmosOf(m_window->document().effect(), view)) {
            if (gizmo.id == id) {
                const Projected at = project(view, gizmo.to);
                return {qRound(at.x), qRound(at.y)};
            }
        }
        return {};
    }
};

FUMAGE_TEST_MAIN(WindowViewportTest)
#include "window_viewport_test.moc"
