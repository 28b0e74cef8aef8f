#include "ui/timeline/key_graph.h"

#include "ui/timeline/key_clipboard.h"
#include "ui/timeline/key_drag.h"
#include "ui/timeline/key_menu.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fumage::ui {

namespace {

constexpr double kAxisWidth = 48.0; ///< of the texts of the axis, pixels
constexpr Qt::KeyboardModifiers kIgnored = Qt::ShiftModifier | Qt::KeypadModifier;

} // namespace

// --- the mouse ---

void KeyGraph::mousePressEvent(QMouseEvent* event)
{
    if (m_drag != Drag::None || (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton)) {
        return;
    }
    m_nudges.end();
    m_press = m_at = event->position();
    m_hasMoved = false;
    m_axisBefore = axis();
    m_dragged = m_selection.keys();
    if (event->button() == Qt::MiddleButton) {
        m_drag = Drag::Pan;
    } else if (const std::optional<Hit> hit = hitAt(m_press)) {
        begin(*hit, event->modifiers());
    } else {
        m_drag = Drag::Box;
        if (!event->modifiers().testFlag(Qt::ShiftModifier)) {
            m_selection.select({});
        }
    }
    update();
}

void KeyGraph::begin(const Hit& hit, Qt::KeyboardModifiers modifiers)
{
    m_grip = hit;
    m_component = hit.component;
    m_drag = hit.isHandle ? Drag::Handle : Drag::Keys;
    if (hit.isHandle) {
        m_offset = handleOf(hit.key, hit.isAfter, hit.component).value_or(m_press) - m_press;
    } else {
        m_selection.press(hit.key, modifiers);
    }
    m_gesture = m_document.beginGesture();
    m_base = m_selection.tracks();
    m_dragged = m_selection.keys();
}

void KeyGraph::mouseMoveEvent(QMouseEvent* event)
{
    constexpr double kStill = 3.0;
    const QPointF step = event->position() - m_at;
    m_at = event->position();
    m_hasMoved = m_hasMoved || (m_at - m_press).manhattanLength() > kStill;
    switch (m_drag) {
    case Drag::None: return;
    case Drag::Keys:
        if (m_hasMoved) {
            dragKeys(event->modifiers());
        }
        break;
    case Drag::Handle:
        if (m_hasMoved) {
            dragHandle(event->modifiers().testFlag(Qt::ControlModifier));
        }
        break;
    case Drag::Box: m_selection.select(keysIn(QRectF(m_press, m_at).normalized())); break;
    case Drag::Pan:
        m_axis.move(step.y() * m_axis.perPixel());
        m_isFitted = false;
        break;
    }
    update();
}

void KeyGraph::dragKeys(Qt::KeyboardModifiers modifiers)
{
    const QPointF way = m_at - m_press;
    const bool keepsToOne = modifiers.testFlag(Qt::ShiftModifier);
    const bool isAlong = std::abs(way.x()) >= std::abs(way.y());
    const bool stretches = modifiers.testFlag(Qt::AltModifier);
    const double from = frameSecondsAt(m_press.x());
    const double to = keepsToOne && !isAlong ? from : frameSecondsAt(m_at.x());
    const double by = stretches || (keepsToOne && isAlong) ? 0.0 : -way.y() * m_axis.perPixel();
    std::vector<Track> tracks = m_base;
    for (Track& track : tracks) {
        raiseKeys(track, m_dragged, m_grip.component, by);
    }
    const MovedKeys moved = movedKeys(std::move(tracks), m_dragged, {from, to, stretches}, frameRate());
    replaceTracks(m_document, moved.tracks, tr("Move key frames"), m_gesture);
    m_selection.select(moved.keys);
}

void KeyGraph::dragHandle(bool breaks)
{
    const auto base = std::find_if(
        m_base.begin(), m_base.end(), [this](const Track& track) { return track.parameter == m_grip.key.parameter; });
    if (base == m_base.end()) {
        return;
    }
    const std::size_t index = keyIndex(*base, m_grip.key.seconds);
    if (index >= base->keys.size()) {
        return;
    }
    const TimeScale times = scale();
    const QPointF end = m_at + m_offset;
    constexpr double kSteepest = 1.0; // pixels beside the key: a handle points away from it
    const double away = end.x() - times.xOf(m_grip.key.seconds);
    const double pixels = m_grip.isAfter ? std::max(kSteepest, away) : std::min(-kSteepest, away);
    const double value = componentOf(base->keys[index].value, m_grip.component);
    const double slope = (m_axis.valueAt(end.y()) - value) / pixels * times.perSecond;
    Track track = *base;
    bendKey(track, index, m_grip.component, slope, !breaks || !m_grip.isAfter, !breaks || m_grip.isAfter);
    replaceTracks(m_document, {track}, tr("Bend a curve"), m_gesture);
}

void KeyGraph::takeBack()
{
    if (m_drag == Drag::Keys || m_drag == Drag::Handle) {
        replaceTracks(m_document, m_base, {}, m_gesture);
    } else if (m_drag == Drag::Pan) {
        m_axis = m_axisBefore;
    }
    m_drag = Drag::None;
    m_selection.select(m_dragged);
    update();
}

void KeyGraph::mouseReleaseEvent(QMouseEvent* event)
{
    if (m_drag == Drag::None || event->button() != (m_drag == Drag::Pan ? Qt::MiddleButton : Qt::LeftButton)) {
        return;
    }
    const bool isClick = !m_hasMoved && (m_drag == Drag::Keys || m_drag == Drag::Box);
    m_drag = Drag::None;
    if (isClick) {
        m_player.pause();
        m_player.setFrame(static_cast<int>(std::lround(frameSecondsAt(m_press.x()) * frameRate())));
    }
    update();
}

void KeyGraph::mouseDoubleClickEvent(QMouseEvent* event)
{
    const QPointF at = event->position();
    if (event->button() != Qt::LeftButton || hitAt(at)) {
        return;
    }
    if (const GraphCurve* curve = curveAt(at)) {
        const Parameter& parameter = *curve->parameter;
        m_component = curve->component;
        if (const std::optional<double> time = addKeyOnCurve(m_document, parameter, frameSecondsAt(at.x()))) {
            m_selection.select({{&parameter, *time}});
        }
    } else if (at.x() < kAxisWidth) {
        frameAll();
    }
}

void KeyGraph::wheelEvent(QWheelEvent* event)
{
    constexpr double kNotch = 0.85;
    m_axis.zoom(std::pow(kNotch, wheelSteps(*event)), axis().valueAt(event->position().y()));
    m_isFitted = false;
    event->accept();
    update();
}

// --- the keyboard ---

bool KeyGraph::event(QEvent* event)
{
    if (event->type() == DragCancel::type() && m_drag != Drag::None) {
        takeBack();
        event->accept();
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride && wants(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void KeyGraph::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    forget();
}

bool KeyGraph::wants(const QKeyEvent& event) const
{
    if (event.key() == Qt::Key_Delete || event.matches(QKeySequence::Copy) || event.matches(QKeySequence::Paste)
        || event.matches(QKeySequence::SelectAll)) {
        return true;
    }
    const bool isArrow = event.key() == Qt::Key_Left || event.key() == Qt::Key_Right || event.key() == Qt::Key_Up
        || event.key() == Qt::Key_Down;
    const bool isPlain = (event.modifiers() & ~kIgnored) == Qt::NoModifier;
    return (event.key() == Qt::Key_F && event.modifiers() == Qt::NoModifier)
        || (isArrow && isPlain && !m_selection.keys().empty());
}

void KeyGraph::keyPressEvent(QKeyEvent* event)
{
    constexpr int kMany = 10; // with Shift
    const int steps = event->modifiers().testFlag(Qt::ShiftModifier) ? kMany : 1;
    if (!wants(*event)) {
        QWidget::keyPressEvent(event);
    } else if (event->key() == Qt::Key_Delete) {
        removeKeys(m_document, m_selection.keys());
    } else if (event->key() == Qt::Key_F) {
        frameAll();
    } else if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right) {
        nudge(event->key() == Qt::Key_Left ? -steps : steps, 0);
    } else if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down) {
        nudge(0, event->key() == Qt::Key_Up ? steps : -steps);
    } else if (event->matches(QKeySequence::Copy)) {
        copyKeys(m_document, m_selection.keys());
    } else if (event->matches(QKeySequence::Paste)) {
        m_selection.select(pasteKeys(m_document));
    } else {
        const double all = std::numeric_limits<float>::max();
        m_selection.select(keysIn(QRectF(-all, -all, 2.0 * all, 2.0 * all)));
    }
}

void KeyGraph::nudge(int frames, int steps)
{
    if (!m_nudges.isActive()) {
        m_nudge = m_document.beginGesture();
    }
    m_nudges.start();
    const std::vector<KeyPlace> keys = m_selection.keys();
    std::vector<Track> tracks = m_selection.tracks();
    for (Track& track : tracks) {
        raiseKeys(track, keys, m_component, steps * track.parameter->step);
    }
    const MovedKeys moved = movedKeys(std::move(tracks), keys, {0.0, frames / frameRate()}, frameRate());
    replaceTracks(m_document, moved.tracks, tr("Move key frames"), m_nudge);
    m_selection.select(moved.keys);
}

void KeyGraph::contextMenuEvent(QContextMenuEvent* event)
{
    const std::optional<Hit> hit = hitAt(event->pos());
    if (hit && !m_selection.contains(hit->key)) {
        m_selection.select({hit->key});
    }
    const GraphCurve* curve = curveAt(event->pos());
    const Parameter* about = hit ? hit->key.parameter : curve != nullptr ? curve->parameter : nullptr;
    QMenu menu(this);
    fillKeyMenu(menu, m_document, m_selection, about != nullptr ? m_selection.track(*about) : nullptr);
    menu.exec(event->globalPos());
}

} // namespace fumage::ui
