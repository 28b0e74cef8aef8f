#include "ui/viewport/viewport_input.h"

#include "ui/document/key_edits.h"
#include "ui/viewport/animation_overlay.h"
#include "ui/widgets/input_guard.h"

#include "core/effect/known_parameter.h"
#include "core/effect/value.h"

#include <QContextMenuEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QWheelEvent>
#include <QWidget>

namespace fumage::ui {

namespace {

constexpr double kClick = 4.0; ///< pixels that the mouse may move between press and release

} // namespace

ViewportInput::ViewportInput(
    Document& document, SplitView& split, QWidget& surface, std::function<View()> view, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_split(split)
    , m_surface(surface)
    , m_view(std::move(view))
{
    surface.setFocusPolicy(Qt::StrongFocus);
    surface.setMouseTracking(true);
    InputGuard::leaveAllButtons(surface);
    surface.installEventFilter(this);
    connect(&m_wheelTimer, &GestureTimer::ended, this, [this] { m_wheelGesture = {}; });
}

std::optional<GizmoId> ViewportInput::gizmo() const
{
    if (!m_drag) {
        return m_hot;
    }
    const GizmoId* dragged = std::get_if<GizmoId>(&m_drag->grip);
    return dragged != nullptr ? std::optional(*dragged) : std::nullopt;
}

bool ViewportInput::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != &m_surface) {
        return false;
    }
    if (event->type() == DragCancel::type() && m_drag) {
        takeBack();
        event->accept();
        return true;
    }
    switch (event->type()) {
    case QEvent::MouseButtonPress: press(static_cast<const QMouseEvent&>(*event)); return true;
    case QEvent::MouseMove: move(static_cast<const QMouseEvent&>(*event)); return true;
    case QEvent::MouseButtonRelease: release(static_cast<const QMouseEvent&>(*event)); return true;
    case QEvent::Wheel: wheel(static_cast<const QWheelEvent&>(*event)); return true;
    case QEvent::Enter: setInside(true); return false;
    case QEvent::Leave:
        setHot(std::nullopt);
        setInside(false);
        return false;
    case QEvent::ContextMenu:
        if (const auto& menu = static_cast<const QContextMenuEvent&>(*event);
            menu.reason() == QContextMenuEvent::Keyboard) {
            emit menuRequested(m_surface.mapToGlobal(m_surface.rect().center()));
        }
        return true; // that of the mouse comes before it is known whether it will drag
    default: return false;
    }
}

std::optional<ViewportInput::Grip> ViewportInput::gripFor(const QMouseEvent& event) const
{
    if (event.button() == Qt::LeftButton) {
        if (m_split.isAtLine(event.position().x(), m_surface.width())) {
            return DividingLine();
        }
        // With Alt the left button moves the camera wherever it is.
        if (m_gizmos && !event.modifiers().testFlag(Qt::AltModifier)) {
            if (const std::optional<GizmoId> gizmo = gizmoAt(m_document.effect(), m_view(), event.position())) {
                return *gizmo;
            }
            const Track* seen = way();
            if (const std::optional<double> key =
                    seen != nullptr ? wayKeyAt(*seen, m_view(), event.position()) : std::nullopt) {
                return WayKey{*key};
            }
        }
    }
    if (const std::optional<CameraMove> move = cameraMoveFor(m_style, event.button(), event.modifiers())) {
        return *move;
    }
    return std::nullopt;
}

void ViewportInput::press(const QMouseEvent& event)
{
    m_surface.setFocus(Qt::MouseFocusReason);
    if (event.button() == Qt::RightButton) {
        m_rightPress = event.globalPosition();
    }
    if (m_drag) {
        return; // a second button
    }
    if (const std::optional<Grip> grip = gripFor(event)) {
        m_drag = Drag{*grip, event.button(), EndlessWay(), m_document.effect(), m_document.scene(), m_view(),
            m_document.beginGesture()};
        m_drag->isClick = event.button() == Qt::LeftButton && std::holds_alternative<CameraMove>(*grip);
        m_drag->way.begin(event);
    }
}

void ViewportInput::release(const QMouseEvent& event)
{
    const bool isFree = !m_drag || event.button() == m_drag->button;
    if (m_drag && event.button() == m_drag->button) {
        const bool isClick = m_drag->isClick;
        m_drag.reset();
        if (isClick) {
            emit clicked(event.position(), event.modifiers());
        }
    }
    if (event.button() == Qt::RightButton && isFree && QLineF(event.globalPosition(), m_rightPress).length() < kClick) {
        emit menuRequested(event.globalPosition().toPoint());
    }
}

void ViewportInput::takeBack()
{
    const Scene& before = m_drag->scene;
    const std::size_t layer = m_document.layer();
    const bool isThere = layer < before.layers.size();
    if (isThere && !(before.allTracks(layer) == m_document.scene().allTracks(layer))) {
        m_document.replaceScene(before, m_document.selection(), {}, m_drag->gesture); // keys that came go, too
    } else {
        m_document.moveCamera(m_drag->before.camera, m_drag->gesture);
        std::vector<Assignment> assignments;
        for (const Parameter* parameter : differences(m_drag->before, m_document.effect())) {
            assignments.push_back({parameter, parameter->get(m_drag->before)});
        }
        m_document.edit(assignments, {}, m_drag->gesture);
    }
    m_drag.reset();
}

void ViewportInput::move(const QMouseEvent& event)
{
    setInside(m_surface.rect().contains(event.position().toPoint()));
    if (m_drag) {
        std::visit([&](auto grip) { drag(grip, event); }, m_drag->grip);
    } else {
        setHot(m_gizmos ? gizmoAt(m_document.effect(), m_view(), event.position()) : std::nullopt);
        const Track* seen = m_gizmos && !m_hot ? way() : nullptr;
        const bool isOnKey = seen != nullptr && wayKeyAt(*seen, m_view(), event.position());
        m_surface.setCursor(m_hot || isOnKey ? Qt::OpenHandCursor : Qt::ArrowCursor);
    }
}

void ViewportInput::drag(DividingLine, const QMouseEvent& event)
{
    m_split.moveLine(event.position().x(), m_surface.width());
    m_surface.update();
}

void ViewportInput::drag(GizmoId gizmo, const QMouseEvent& event)
{
    const bool snap = event.modifiers().testFlag(Qt::ControlModifier);
    m_document.edit(dragGizmo(gizmo, m_drag->before, m_drag->view, event.position(), snap), {}, m_drag->gesture);
}

const Track* ViewportInput::way() const
{
    return m_document.track(knownParameter("emitter.position"));
}

void ViewportInput::drag(WayKey key, const QMouseEvent& event)
{
    const Parameter& position = knownParameter("emitter.position");
    const std::size_t layer = m_document.layer();
    const Track* before =
        layer < m_drag->scene.layers.size() ? m_drag->scene.tracksOf(position, layer).find(position) : nullptr;
    const KeyFrame* gripped = before != nullptr ? keyAt(*before, key.seconds) : nullptr;
    if (gripped == nullptr) {
        return; // another layer is edited by now
    }
    Track way = *before;
    KeyFrame moved = *gripped;
    const bool snap = event.modifiers().testFlag(Qt::ControlModifier);
    moved.value = placeFacing(m_drag->view, std::get<glm::vec3>(moved.value), event.position(), snap);
    setKey(way, moved);
    replaceTracks(m_document, {way}, tr("Move a key frame of the way"), m_drag->gesture);
}

void ViewportInput::drag(CameraMove move, const QMouseEvent& event)
{
    const QPointF way = m_drag->way.to(event);
    m_drag->isClick = m_drag->isClick && QLineF({}, way).length() < kClick;
    if (m_drag->isClick) {
        return; // a hand that clicks is not quite still
    }
    const Camera& before = m_drag->before.camera;
    const auto apply = [this](const Camera& camera) { m_document.moveCamera(camera, m_drag->gesture); };
    switch (move) {
    case CameraMove::Orbit: apply(orbited(before, way, m_drag->view)); break;
    case CameraMove::Pan: apply(panned(before, way, m_drag->view)); break;
    case CameraMove::Look: apply(lookedAround(before, way, m_drag->view)); break;
    case CameraMove::Zoom:
        constexpr double kNotchesAPixel = 0.03;
        apply(zoomed(before, -way.y() * kNotchesAPixel, m_drag->view));
        break;
    }
}

void ViewportInput::wheel(const QWheelEvent& event)
{
    if (m_drag || event.angleDelta().y() == 0) {
        return;
    }
    if (m_wheelGesture.id == 0) {
        m_wheelGesture = m_document.beginGesture();
    }
    m_wheelTimer.start();
    m_document.moveCamera(zoomed(m_document.effect().camera, wheelSteps(event), m_view()), m_wheelGesture);
}

void ViewportInput::setInside(bool inside)
{
    if (inside != m_isInside) {
        m_isInside = inside;
        m_surface.update();
    }
}

void ViewportInput::setHot(std::optional<GizmoId> gizmo)
{
    if (gizmo != m_hot) {
        m_hot = gizmo;
        m_surface.update();
    }
}

} // namespace fumage::ui
