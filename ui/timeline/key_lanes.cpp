#include "ui/timeline/key_lanes.h"

#include "ui/document/parameter_text.h"
#include "ui/timeline/key_clipboard.h"
#include "ui/timeline/key_drag.h"
#include "ui/timeline/key_mends.h"
#include "ui/timeline/key_menu.h"
#include "ui/timeline/timeline_marks.h"
#include "ui/timeline/timeline_ruler.h"
#include "ui/widgets/diamond.h"
#include "ui/widgets/gesture.h"
#include "ui/widgets/plain_text.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace fumage::ui {

namespace {

constexpr double kReach = 7.0; ///< of a key under the hand, pixels
constexpr double kRadius = 4.5;

} // namespace

KeyLanes::KeyLanes(
    Document& document, Player& player, const TimelineRuler& ruler, KeySelection& selection, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_player(player)
    , m_ruler(ruler)
    , m_selection(selection)
{
    setObjectName(QStringLiteral("keyLanes"));
    setAccessibleName(tr("Key frames"));
    setToolTip(tr("Drag key frames to other times; Alt stretches, Delete removes, a double-click adds one"));
    setFocusPolicy(Qt::ClickFocus);
    connect(&selection, &KeySelection::tracksChanged, this, &KeyLanes::fitHeight);
    connect(&selection, &KeySelection::changed, this, qOverload<>(&QWidget::update));
    connect(&player, &Player::frameChanged, this, qOverload<>(&QWidget::update));
    connect(&player, &Player::settingsChanged, this, qOverload<>(&QWidget::update));
    fitHeight();
}

void KeyLanes::setMarksShown(bool marks)
{
    m_marksShown = marks;
    update();
}

QSize KeyLanes::sizeHint() const
{
    return {400, kLaneHeight * static_cast<int>(m_selection.tracks().size())};
}

void KeyLanes::fitHeight()
{
    if (height() != sizeHint().height()) {
        setFixedHeight(sizeHint().height());
        emit heightChanged();
    }
    update();
}

double KeyLanes::frameRate() const
{
    return m_document.scene().timeline.frameRate;
}

double KeyLanes::secondsAt(double x) const
{
    const double perFrame = m_ruler.xOf(1.0) - m_ruler.xOf(0.0);
    return std::max(0.0, std::round((x - m_ruler.xOf(0.0)) / perFrame)) / frameRate();
}

const Track* KeyLanes::trackAt(double y) const
{
    const auto lane = static_cast<std::size_t>(std::max(0.0, y) / kLaneHeight);
    return lane < m_selection.tracks().size() ? &m_selection.tracks()[lane] : nullptr;
}

QPointF KeyLanes::placeOf(const KeyPlace& key) const
{
    const auto lane = std::find_if(m_selection.tracks().begin(), m_selection.tracks().end(),
        [&](const Track& track) { return track.parameter == key.parameter; });
    return {m_ruler.xOf(key.seconds * frameRate()),
        (static_cast<double>(lane - m_selection.tracks().begin()) + 0.5) * static_cast<double>(kLaneHeight)};
}

std::optional<KeyPlace> KeyLanes::keyUnder(const QPointF& at) const
{
    const Track* track = trackAt(at.y());
    std::optional<KeyPlace> nearest;
    double reach = kReach;
    for (const KeyFrame& key : track != nullptr ? track->keys : std::vector<KeyFrame>()) {
        const double away = std::abs(m_ruler.xOf(key.seconds * frameRate()) - at.x());
        if (away < reach) {
            reach = away;
            nearest = KeyPlace{track->parameter, key.seconds};
        }
    }
    return nearest;
}

std::vector<KeyPlace> KeyLanes::keysIn(const QRectF& box) const
{
    std::vector<KeyPlace> keys;
    for (const Track& track : m_selection.tracks()) {
        for (const KeyFrame& key : track.keys) {
            const KeyPlace place{track.parameter, key.seconds};
            if (box.contains(placeOf(place))) {
                keys.push_back(place);
            }
        }
    }
    return keys;
}

void KeyLanes::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || m_drag != Drag::None) {
        return;
    }
    m_press = m_at = event->position();
    m_hasMoved = false;
    if (const std::optional<KeyPlace> key = keyUnder(m_press)) {
        m_selection.press(*key, event->modifiers());
        m_drag = Drag::Keys;
        m_gesture = m_document.beginGesture();
        m_base = m_selection.tracks();
        m_dragged = m_selection.keys();
    } else {
        m_drag = Drag::Box;
        m_dragged = m_selection.keys(); // that Escape chooses again
        if (!event->modifiers().testFlag(Qt::ShiftModifier)) {
            m_selection.select({});
        }
        if (const Track* track = trackAt(m_press.y())) {
            m_selection.show(*track->parameter, event->modifiers().testFlag(Qt::ControlModifier));
        }
    }
    update();
}

void KeyLanes::mouseMoveEvent(QMouseEvent* event)
{
    constexpr double kStill = 3.0;
    m_at = event->position();
    m_hasMoved = m_hasMoved || (m_at - m_press).manhattanLength() > kStill;
    if (m_drag == Drag::Keys && m_hasMoved) {
        dragKeys(m_at, event->modifiers().testFlag(Qt::AltModifier));
    } else if (m_drag == Drag::Box) {
        m_selection.select(keysIn(QRectF(m_press, m_at).normalized()));
    }
    update();
}

void KeyLanes::dragKeys(const QPointF& to, bool stretches)
{
    const MovedKeys moved =
        movedKeys(m_base, m_dragged, {secondsAt(m_press.x()), secondsAt(to.x()), stretches}, frameRate());
    replaceTracks(m_document, moved.tracks, tr("Move key frames"), m_gesture);
    m_selection.select(moved.keys);
}

void KeyLanes::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        return;
    }
    const bool isClick = m_drag != Drag::None && !m_hasMoved;
    m_drag = Drag::None;
    if (isClick) {
        m_player.pause();
        m_player.setFrame(static_cast<int>(std::lround(secondsAt(m_press.x()) * frameRate())));
    }
    update();
}

void KeyLanes::mouseDoubleClickEvent(QMouseEvent* event)
{
    const Track* track = trackAt(event->position().y());
    if (event->button() == Qt::LeftButton && track != nullptr && !keyUnder(event->position())) {
        const Parameter& parameter = *track->parameter;
        m_player.setFrame(static_cast<int>(std::lround(secondsAt(event->position().x()) * frameRate())));
        if (const std::optional<double> time = addKeyOnCurve(m_document, parameter, secondsAt(event->position().x()))) {
            m_selection.select({{&parameter, *time}});
        }
    }
}

bool KeyLanes::event(QEvent* event)
{
    if (event->type() == DragCancel::type() && m_drag != Drag::None) {
        if (m_drag == Drag::Keys) {
            replaceTracks(m_document, m_base, {}, m_gesture);
        }
        m_drag = Drag::None; // nor is the release a click
        m_selection.select(m_dragged);
        update();
        event->accept();
        return true;
    }
    if (event->type() == QEvent::ToolTip) {
        const auto& help = *static_cast<QHelpEvent*>(event);
        const Track* track = trackAt(help.pos().y());
        QString tip = track != nullptr ? keyFaultsTold(*track, m_document.scene().timeline) : QString();
        QToolTip::showText(help.globalPos(), plainToolTip(tip + toolTip()), this);
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if (key.key() == Qt::Key_Delete || key.matches(QKeySequence::Copy) || key.matches(QKeySequence::Paste)
            || key.matches(QKeySequence::SelectAll)) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void KeyLanes::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Delete && !m_selection.keys().empty()) {
        removeKeys(m_document, m_selection.keys());
    } else if (event->matches(QKeySequence::Copy)) {
        copyKeys(m_document, m_selection.keys());
    } else if (event->matches(QKeySequence::Paste)) {
        m_selection.select(pasteKeys(m_document));
    } else if (event->matches(QKeySequence::SelectAll)) {
        m_selection.select(keysIn(rect().adjusted(-width(), 0, width(), 0)));
    } else {
        QWidget::keyPressEvent(event);
    }
    update();
}

void KeyLanes::contextMenuEvent(QContextMenuEvent* event)
{
    if (const std::optional<KeyPlace> key = keyUnder(event->pos()); key && !m_selection.contains(*key)) {
        m_selection.select({*key});
    }
    QMenu menu(this);
    fillKeyMenu(menu, m_document, m_selection, trackAt(event->pos().y()));
    menu.exec(event->globalPos());
}

double KeyLanes::labelLeft(const Track& track, const QString& label) const
{
    constexpr double kGap = 2.0 * kRadius;
    const double needed = fontMetrics().horizontalAdvance(label) + kGap;
    const double first = m_ruler.xOf(0.0) + kGap;
    double left = first;
    for (const KeyFrame& key : track.keys) {
        const double x = m_ruler.xOf(key.seconds * frameRate());
        if (left + needed <= x) {
            break;
        }
        left = std::max(left, x + kGap);
    }
    return left + needed <= width() ? left : first;
}

void KeyLanes::paintLane(QPainter& painter, const Track& track, double top) const
{
    const Parameter& parameter = *track.parameter;
    QColor faint = palette().text().color();
    constexpr int kFaint = 28;
    constexpr int kMarked = 64;
    faint.setAlpha(m_marksShown && m_selection.isShown(parameter) ? kMarked : kFaint);
    painter.fillRect(QRectF(0.0, top, width(), kLaneHeight - 1.0), faint);
    if (parameter.kind == Kind::Float) {
        const auto valueAt = [&](double seconds) { return std::get<float>(track.at(seconds)); };
        std::vector<float> values;
        constexpr int kStep = 2; // pixels
        const double perSecond = (m_ruler.xOf(1.0) - m_ruler.xOf(0.0)) * frameRate();
        const double left = m_ruler.xOf(0.0);
        for (double x = left; x < width() - left; x += kStep) {
            values.push_back(valueAt((x - left) / perSecond));
        }
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        QPolygonF line;
        for (std::size_t i = 0; i < values.size() && *high > *low; ++i) {
            const double up = static_cast<double>((values[i] - *low) / (*high - *low));
            line << QPointF(left + kStep * static_cast<double>(i), top + 2.0 + (1.0 - up) * (kLaneHeight - 5.0));
        }
        QColor curve = palette().highlight().color();
        curve.setAlpha(150);
        painter.setPen(QPen(curve, 1.2));
        painter.drawPolyline(line);
    }
    const bool isWhole = keyFaults(track, m_document.scene().timeline).empty();
    QColor text = palette().text().color();
    text.setAlpha(170);
    painter.setPen(text);
    const QString label = (isWhole ? QString() : QStringLiteral("⚠ ")) + fullLabelOf(parameter);
    painter.drawText(
        QRectF(labelLeft(track, label), top, width(), kLaneHeight - 1.0), Qt::AlignLeft | Qt::AlignVCenter, label);
    for (const KeyFrame& key : track.keys) {
        const bool chosen = m_selection.contains({&parameter, key.seconds});
        paintDiamond(painter, placeOf({&parameter, key.seconds}), kRadius,
            chosen ? palette().highlight().color() : palette().text().color(), true);
    }
}

void KeyLanes::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t lane = 0; lane < m_selection.tracks().size(); ++lane) {
        paintLane(painter, m_selection.tracks()[lane], static_cast<double>(lane) * kLaneHeight);
    }
    const double x = m_ruler.xOf(m_player.frame());
    paintPlayhead(painter, *this, x);
    if (m_drag == Drag::Box && m_hasMoved) {
        paintSelectionBox(painter, *this, QRectF(m_press, m_at).normalized());
    }
}

} // namespace fumage::ui
