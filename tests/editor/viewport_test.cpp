// Cameras and gizmos: what needs no window.
#include "editor_helpers.h"

#include "ui/document/key_edits.h"
#include "ui/preview/picture.h"
#include "ui/viewport/animation_overlay.h"
#include "ui/viewport/gizmo_painter.h"
#include "ui/viewport/navigation.h"
#include "ui/viewport/overlays.h"
#include "ui/viewport/viewport_input.h"

#include "core/effect/known_parameter.h"

#include <glm/geometric.hpp>

using namespace fumage;
using namespace fumage::tests;

namespace {

QPointF onScreen(const View& view, const glm::vec3& point)
{
    const Projected at = project(view, point);
    return {static_cast<double>(at.x), static_cast<double>(at.y)};
}

const Gizmo gizmoOf(const Effect& effect, const View& view, GizmoId id)
{
    for (const Gizmo& gizmo : gizmosOf(effect, view)) {
        if (gizmo.id == id) {
            return gizmo;
        }
    }
    return {};
}

Effect applied(Effect effect, const std::vector<Assignment>& assignments)
{
    for (const Assignment& assignment : assignments) {
        assignment.parameter->set(effect, assignment.value);
    }
    return effect;
}

} // namespace

class ViewportTest : public QObject {
    Q_OBJECT

private slots:
    // --- camera -----------------------------------------------------------------------------------------------------

    void panningKeepsThePointUnderTheMouse()
    {
        const Effect effect;
        const View view = windowView(effect, 0, 800, 600);
        const QPointF before = onScreen(view, effect.camera.target);
        Effect moved = effect;
        moved.camera = panned(effect.camera, {37.0, -21.0}, view);
        const QPointF after = onScreen(windowView(moved, 0, 800, 600), effect.camera.target);
        QVERIFY(QLineF(after, before + QPointF(37.0, -21.0)).length() < 0.1);
    }

    void orbitingKeepsDistanceAndTarget()
    {
        const Camera camera = orbited(Effect().camera, {100.0, 60.0}, windowView(Effect(), 0, 800, 600));
        QCOMPARE(camera.distance, Effect().camera.distance);
        QVERIFY(camera.target == Effect().camera.target);
        QVERIFY(camera.yaw != Effect().camera.yaw && camera.pitch != Effect().camera.pitch);
    }

    void lookingAroundLeavesTheEyeWhereItIs()
    {
        Effect effect;
        effect.camera.turntable = 30.0F;
        constexpr int kFrame = 45;
        const View before = windowView(effect, kFrame, 800, 600);
        effect.camera = lookedAround(effect.camera, {100.0, 60.0}, before);
        const View after = windowView(effect, kFrame, 800, 600);
        QVERIFY(glm::length(after.eye - before.eye) < 1e-4F);
        QVERIFY(glm::dot(after.forward, before.right) > 0.1F); // the way the mouse went
        QVERIFY(after.forward.y < before.forward.y);
    }

    void orbitingNeverGoesOverThePole()
    {
        const Camera camera = orbited(Effect().camera, {0.0, 5000.0}, windowView(Effect(), 0, 800, 600));
        QVERIFY(camera.pitch <= 89.0F);
    }

    void framingHoldsTheWholeBox()
    {
        Effect effect;
        effect.camera = framing(effect.camera, {-3.0F, 0.0F, -1.0F}, {2.0F, 5.0F, 4.0F});
        const View view = windowView(effect, 0, 600, 600);
        for (int i = 0; i < 8; ++i) {
            const QPointF at = onScreen(view, {i & 1 ? -3.0F : 2.0F, i & 2 ? 0.0F : 5.0F, i & 4 ? -1.0F : 4.0F});
            QVERIFY(QRectF(0, 0, 600, 600).contains(at));
        }
    }

    void anOutlineIsFoundUnderTheMouse()
    {
        Scene scene;
        scene.layers.resize(3);
        scene.layers[1].emitter.position = {1.5F, 0.0F, 0.0F};
        scene.layers[2].emitter.position = {-1.5F, 0.5F, 0.0F};
        scene.layers[2].emitter.shape = EmitterShape::Rectangle;
        const View view = windowView(scene, 0, 800, 600);
        const std::vector<std::size_t> all{0, 1, 2};
        for (const std::size_t layer : all) {
            const QPointF onIt = emitterOutline(scene.layers[layer].emitter, view).front().center();
            QCOMPARE(emitterAt(scene, all, view, onIt), std::optional(layer));
            QCOMPARE(emitterAt(scene, {}, view, onIt), std::nullopt);
        }
        QCOMPARE(emitterAt(scene, all, view, {5.0, 5.0}), std::nullopt);
    }

    void buttonsMeanWhatTheirProgramsTaughtTheHand()
    {
        using S = NavigationStyle;
        QCOMPARE(cameraMoveFor(S::Blender, Qt::MiddleButton, {}), CameraMove::Orbit);
        QCOMPARE(cameraMoveFor(S::Blender, Qt::MiddleButton, Qt::ShiftModifier), CameraMove::Pan);
        QCOMPARE(cameraMoveFor(S::Blender, Qt::MiddleButton, Qt::ControlModifier), CameraMove::Zoom);
        QCOMPARE(cameraMoveFor(S::Maya, Qt::LeftButton, Qt::AltModifier), CameraMove::Orbit);
        QCOMPARE(cameraMoveFor(S::Maya, Qt::MiddleButton, Qt::AltModifier), CameraMove::Pan);
        QCOMPARE(cameraMoveFor(S::Maya, Qt::RightButton, Qt::AltModifier), CameraMove::Zoom);
        QVERIFY(!cameraMoveFor(S::Maya, Qt::MiddleButton, {}).has_value());
        QVERIFY(!cameraMoveFor(S::Maya, Qt::RightButton, {}).has_value());
        QCOMPARE(cameraMoveFor(S::Unity, Qt::MiddleButton, {}), CameraMove::Pan);
        QCOMPARE(cameraMoveFor(S::Unity, Qt::RightButton, {}), CameraMove::Look);
        QCOMPARE(cameraMoveFor(S::Unity, Qt::RightButton, Qt::AltModifier), CameraMove::Zoom);
        QVERIFY(!cameraMoveFor(S::Blender, Qt::RightButton, {}).has_value());
    }

    void theExportedFrameIsTheSameInAnyWindow()
    {
        // A point at the corner of the exported picture lies at the corner of the frame in the window.
        Effect effect;
        effect.output.width = 640;
        effect.output.height = 256;
        const View picture = makeView(effect.camera, 0.0F, 640, 256);
        for (const QSize size : {QSize(900, 700), QSize(500, 900), QSize(640, 256)}) {
            const View view = windowView(effect, 0, size.width(), size.height());
            const QRectF frame = exportFrame(effect, size.width(), size.height());
            const glm::vec3 corner = picture.eye + rayThrough(picture, {0.0, 0.0}) * 5.0F;
            QVERIFY(QLineF(onScreen(view, corner), frame.topLeft()).length() < 0.05);
        }
    }

    // --- gizmos -----------------------------------------------------------------------------------------------------

    void labelsDoNotLieOverEachOther()
    {
        std::vector<QRectF> taken;
        for (int i = 0; i < 6; ++i) {
            const QRectF wanted(10.0 + i, 20.0 + 3.0 * i, 60.0, 15.0);
            const QRectF place = freePlace(wanted, taken);
            QCOMPARE(place.size(), wanted.size());
            QCOMPARE(place.left(), wanted.left());
            QVERIFY(
                std::none_of(taken.begin(), taken.end(), [&](const QRectF& other) { return other.intersects(place); }));
            taken.push_back(place);
        }
        const QRectF alone(200.0, 20.0, 60.0, 15.0);
        QCOMPARE(freePlace(alone, taken), alone);
    }

    void aGizmoIsFoundUnderTheMouse()
    {
        Effect effect;
        effect.vortex.strength = 1.0F;
        const View view = windowView(effect, 0, 800, 600);
        for (const Gizmo& gizmo : gizmosOf(effect, view)) {
            QCOMPARE(gizmoAt(effect, view, onScreen(view, gizmo.to)), gizmo.id);
        }
        QVERIFY(!gizmoAt(effect, view, {5.0, 5.0}).has_value());
    }

    void aGizmoThatIsNotMovedChangesNothing_data() { addGizmos(); }
    void aGizmoThatIsNotMovedChangesNothing()
    {
        QFETCH(int, id);
        Effect effect;
        effect.vortex.strength = 1.0F;
        effect.emitter.normal = glm::normalize(glm::vec3(0.3F, 0.8F, 0.4F));
        effect.wind.angle = 40.0F;
        const View view = windowView(effect, 0, 800, 600);
        const auto gizmo = static_cast<GizmoId>(id);
        const Effect after =
            applied(effect, dragGizmo(gizmo, effect, view, onScreen(view, gizmoOf(effect, view, gizmo).to), false));
        QVERIFY(glm::length(after.emitter.normal - effect.emitter.normal) < 0.02F);
        QVERIFY(glm::length(after.emitter.position - effect.emitter.position) < 0.01F);
        QVERIFY(glm::length(after.vortex.axis - effect.vortex.axis) < 0.02F);
        QVERIFY(glm::length(glm::normalize(after.light.direction) - glm::normalize(effect.light.direction)) < 0.02F);
        QVERIFY(qAbs(after.wind.angle - effect.wind.angle) < 1.5F);
        QVERIFY(qAbs(after.rings.radius - effect.rings.radius) < 0.01F);
        QVERIFY(qAbs(after.rings.spacing - effect.rings.spacing) < 0.01F);
    }

    void aDraggedGizmoGoesWhereTheMouseGoes_data() { addGizmos(); }
    void aDraggedGizmoGoesWhereTheMouseGoes()
    {
        QFETCH(int, id);
        Effect effect;
        effect.vortex.strength = 1.0F;
        effect.camera.pitch = 30.0F;
        effect.air.enabled = static_cast<GizmoId>(id) >= GizmoId::Obstacle;
        effect.air.fit = false;
        effect.air.obstacle = Obstacle::Box;
        effect.air.obstaclePosition = {0.6F, 1.4F, 0.2F};
        const View view = windowView(effect, 0, 800, 600);
        const auto gizmo = static_cast<GizmoId>(id);
        const QPointF to = onScreen(view, gizmoOf(effect, view, gizmo).to) + QPointF(-24.0, 18.0);
        const Effect after = applied(effect, dragGizmo(gizmo, effect, view, to, false));
        QVERIFY(!(after == effect));
        const QPointF now = onScreen(view, gizmoOf(after, view, gizmo).to);
        // The wind keeps its length and whole degrees: its direction is what follows.
        if (gizmo == GizmoId::Wind) {
            const QPointF from = onScreen(view, effect.emitter.position);
            QVERIFY(qAbs(QLineF(from, now).angleTo(QLineF(from, to))) < 3.0
                || qAbs(QLineF(from, now).angleTo(QLineF(from, to))) > 357.0);
        } else {
            QVERIFY(QLineF(now, to).length() < 2.0);
        }
    }

    void ringsHaveAHandleOnlyWhereThereAreRings()
    {
        Effect effect;
        effect.rings.strength = 0.0F;
        for (const Gizmo& gizmo : gizmosOf(effect, windowView(effect, 0, 800, 600))) {
            QVERIFY(gizmo.id != GizmoId::Rings);
        }
        // Seen along the axis the ring is a circle around the emitter: there is a handle still, and it can be dragged
        // or not, but nothing breaks.
        effect.rings.strength = 1.0F;
        effect.camera.pitch = 90.0F;
        const View above = windowView(effect, 0, 800, 600);
        const Gizmo handle = gizmoOf(effect, above, GizmoId::Rings);
        QVERIFY(std::isfinite(handle.to.x) && std::isfinite(handle.to.z));
        for (const Assignment& assignment :
            dragGizmo(GizmoId::Rings, effect, above, onScreen(above, handle.to) + QPointF(20.0, 10.0), false)) {
            QVERIFY(std::isfinite(std::get<float>(assignment.value)));
        }
    }

    void snappedAnglesAreMultiplesOfFifteenDegrees()
    {
        const Effect effect;
        const View view = windowView(effect, 0, 800, 600);
        Effect above = effect;
        above.camera.pitch = 60.0F;
        const View fromAbove = windowView(above, 0, 800, 600);
        const Effect after = applied(above, dragGizmo(GizmoId::Wind, above, fromAbove, {300.0, 520.0}, true));
        QVERIFY(qAbs(std::remainder(after.wind.angle, 15.0F)) < 0.01F);
        const Effect turned = applied(effect,
            dragGizmo(GizmoId::EmitterNormal, effect, view,
                onScreen(view, gizmoOf(effect, view, GizmoId::EmitterNormal).to) + QPointF(31, 9), true));
        const float pitch = std::asin(turned.emitter.normal.y) * 57.29578F;
        QVERIFY(qAbs(std::remainder(pitch, 15.0F)) < 0.01F);
    }

    /// The dot goes where the mouse goes, in one undo step; the other keys of the way stay.
    void aKeyOfTheWayIsDraggedByItsDot()
    {
        const Parameter& position = knownParameter("emitter.position");
        const Track way{&position, {{0.5, glm::vec3(-0.6F, 0.2F, 0.0F)}, {1.5, glm::vec3(0.7F, 1.0F, 0.3F)}}};
        Document document;
        replaceTracks(document, {way}, QStringLiteral("Set"));
        SplitView split;
        QWidget surface;
        surface.resize(800, 600);
        const auto view = [&] { return windowView(document.scene(), 0, 800, 600); };
        const ViewportInput input(document, split, surface, view);
        const QPoint from = onScreen(view(), std::get<glm::vec3>(way.keys[1].value)).toPoint();
        QCOMPARE(wayKeyAt(way, view(), from), std::optional(1.5));
        QVERIFY(!wayKeyAt(way, view(), from + QPoint(30, 0)));
        const int steps = document.undoStack()->count();
        dragMouse(surface, from, from + QPoint(40, -25));
        const Track moved = *document.track(position);
        QCOMPARE(moved.keys.size(), std::size_t{2});
        QVERIFY(moved.keys[0] == way.keys[0]);
        QCOMPARE(moved.keys[1].seconds, 1.5);
        const QPointF now = onScreen(view(), std::get<glm::vec3>(moved.keys[1].value));
        QVERIFY2(QLineF(now, from + QPoint(40, -25)).length() < 1.0, qPrintable(QString::number(now.x())));
        QCOMPARE(document.undoStack()->count(), steps + 1);
        document.undoStack()->undo();
        QVERIFY(*document.track(position) == way);
        // Escape in a drag.
        QTest::mousePress(&surface, Qt::LeftButton, {}, from);
        QMouseEvent away(QEvent::MouseMove, from + QPoint(9, 9), surface.mapToGlobal(from), Qt::NoButton,
            Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&surface, &away);
        QVERIFY(!(*document.track(position) == way));
        DragCancel cancel;
        QApplication::sendEvent(&surface, &cancel);
        QVERIFY(*document.track(position) == way);
    }

    /// Also where it has set a key frame.
    void escapeInADragOfAGizmoLeavesNothing_data()
    {
        QTest::addColumn<bool>("autoKey");
        QTest::addColumn<bool>("hasKeys");
        QTest::newRow("a value") << false << false;
        QTest::newRow("auto-key") << true << false;
        QTest::newRow("between key frames") << false << true;
    }
    void escapeInADragOfAGizmoLeavesNothing()
    {
        QFETCH(bool, autoKey);
        QFETCH(bool, hasKeys);
        const Parameter& normal = knownParameter("emitter.normal");
        Preset preset;
        if (hasKeys) {
            preset.scene.layers[0].tracks.set(
                {&normal, {{0.0, glm::vec3(0.0F, 1.0F, 0.0F)}, {2.0, glm::vec3(0.0F, 0.8F, 0.6F)}}});
        }
        Document document;
        document.load(preset, {});
        document.setSeconds(1.0);
        document.setAutoKey(autoKey);
        SplitView split;
        QWidget surface;
        surface.resize(800, 600);
        const auto view = [&] { return windowView(document.scene(), 0, 800, 600); };
        const ViewportInput input(document, split, surface, view);
        const Effect shown = document.effect();
        const QPoint from = onScreen(view(), gizmoOf(shown, view(), GizmoId::EmitterNormal).to).toPoint();
        QTest::mousePress(&surface, Qt::LeftButton, {}, from);
        QMouseEvent away(QEvent::MouseMove, from + QPoint(31, 9), surface.mapToGlobal(from), Qt::NoButton,
            Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&surface, &away);
        QVERIFY(!(normal.get(document.effect()) == normal.get(shown)));
        QCOMPARE(document.track(normal) != nullptr, autoKey || hasKeys);
        DragCancel cancel;
        QApplication::sendEvent(&surface, &cancel);
        QVERIFY(document.scene() == preset.scene);
        QVERIFY(!document.undoStack()->canUndo());
    }

private:
    static void addGizmos()
    {
        QTest::addColumn<int>("id");
        QTest::newRow("emitter position") << static_cast<int>(GizmoId::EmitterPosition);
        QTest::newRow("emitter normal") << static_cast<int>(GizmoId::EmitterNormal);
        QTest::newRow("wind") << static_cast<int>(GizmoId::Wind);
        QTest::newRow("vortex axis") << static_cast<int>(GizmoId::VortexAxis);
        QTest::newRow("rings") << static_cast<int>(GizmoId::Rings);
        QTest::newRow("light") << static_cast<int>(GizmoId::Light);
        QTest::newRow("obstacle") << static_cast<int>(GizmoId::Obstacle);
        QTest::newRow("size of the obstacle") << static_cast<int>(GizmoId::ObstacleSize);
        QTest::newRow("place of the air") << static_cast<int>(GizmoId::AirPlace);
        QTest::newRow("size of the air") << static_cast<int>(GizmoId::AirSize);
    }
};

FUMAGE_TEST_MAIN(ViewportTest)
#include "viewport_test.moc"
