#include "ui/timeline/key_graph.h"

#include "ui/timeline/key_drag.h"
#include "ui/timeline/timeline_ruler.h"
#include "ui/widgets/input_guard.h"

#include <algorithm>
#include <cmath>

namespace fumage::ui {

namespace {

constexpr double kReach = 7.0; ///< of what is under the hand, pixels
constexpr double kHandle = 44.0; ///< length, pixels
constexpr double kMargin = 10.0; ///< above and below the axis of values, pixels

} // namespace

KeyGraph::KeyGraph(
    Document& document, Player& player, const TimelineRuler& ruler, KeySelection& selection, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_player(player)
    , m_ruler(ruler)
    , m_selection(selection)
{
    setObjectName(QStringLiteral("keyGraph"));
    setAccessibleName(tr("Curves of key frames"));
    setToolTip(tr("Drag keys and their handles (Ctrl: one side alone); a double-click on a curve adds a key; the wheel "
                  "zooms the values, F shows all"));
    setFocusPolicy(Qt::ClickFocus);
    setFixedHeight(kHeight);
    InputGuard::leaveAllButtons(*this); // the middle one moves the axis
    connect(&selection, &KeySelection::tracksChanged, this, &KeyGraph::forget);
    connect(&selection, &KeySelection::changed, this, &KeyGraph::follow);
    connect(&player, &Player::frameChanged, this, qOverload<>(&QWidget::update));
    connect(&player, &Player::settingsChanged, this, &KeyGraph::forget);
}

// --- what is shown ---

void KeyGraph::forget()
{
    m_isStale = true;
    update();
}

void KeyGraph::follow()
{
    m_isStale = m_isStale || m_selection.shown() != m_shown;
    update();
}

void KeyGraph::refresh()
{
    if (!m_isStale) {
        return;
    }
    m_isStale = false;
    std::vector<const Parameter*> shown = m_selection.shown();
    std::vector<const Track*> tracks;
    for (const Parameter* parameter : shown) {
        tracks.push_back(m_selection.track(*parameter));
    }
    const bool isOther = shown != m_shown;
    m_shown = std::move(shown);
    m_curves = sampleCurves(tracks, scale());
    m_axis.top = kMargin;
    m_axis.bottom = std::max(height() - kMargin, kMargin + 1.0);
    const auto [low, high] = rangeOf(m_curves);
    const bool isOutside = low < m_axis.low || high > m_axis.high;
    if (isOther || (m_isFitted && isOutside && m_drag == Drag::None)) {
        fit();
    }
}

void KeyGraph::fit()
{
    const auto [low, high] = rangeOf(m_curves);
    double room = 0.0;
    for (const Parameter* parameter : m_shown) {
        constexpr double kSteps = 10.0;
        constexpr double kShare = 0.1;
        constexpr double kMinRoom = 1e-3;
        constexpr double kHalfAStep = 0.5; // of choices
        const double flat = std::max({kSteps * parameter->step, kShare * std::abs(low), kMinRoom});
        room = std::max(room, isRaised(parameter->kind) ? (low == high ? flat : 0.0) : kHalfAStep);
    }
    m_axis.frame(low, high, room);
    m_isFitted = true;
}

void KeyGraph::frameAll()
{
    refresh();
    fit();
    update();
}

const ValueAxis& KeyGraph::axis()
{
    refresh();
    return m_axis;
}

const std::vector<GraphCurve>& KeyGraph::curves()
{
    refresh();
    return m_curves;
}

double KeyGraph::frameRate() const
{
    return m_document.scene().timeline.frameRate;
}

TimeScale KeyGraph::scale() const
{
    const double left = m_ruler.xOf(0.0);
    return {left, (m_ruler.xOf(1.0) - left) * frameRate(), width() - left};
}

double KeyGraph::frameSecondsAt(double x) const
{
    return std::max(0.0, std::round(scale().secondsAt(x) * frameRate())) / frameRate();
}

QPointF KeyGraph::placeOf(const KeyPlace& key, std::size_t component)
{
    refresh();
    const Track* track = m_selection.track(*key.parameter);
    const std::size_t index = track != nullptr ? keyIndex(*track, key.seconds) : 0;
    const bool isThere = track != nullptr && index < track->keys.size();
    return {scale().xOf(key.seconds), m_axis.yOf(isThere ? componentOf(track->keys[index].value, component) : 0.0)};
}

std::optional<QPointF> KeyGraph::handleOf(const KeyPlace& key, bool after, std::size_t component)
{
    const Track* track = m_selection.track(*key.parameter);
    const std::size_t index = track != nullptr ? keyIndex(*track, key.seconds) : 0;
    if (track == nullptr || index >= track->keys.size() || !bends(key.parameter->kind)
        || track->keys[index].ease == Ease::Hold) {
        return std::nullopt;
    }
    const bool isBent = after ? index + 1 < track->keys.size() : index > 0 && track->keys[index - 1].ease != Ease::Hold;
    if (!isBent) {
        return std::nullopt;
    }
    const QPointF place = placeOf(key, component);
    const glm::vec3 slopes = slopeAtKey(*track, index, after);
    const double slope = static_cast<double>(slopes[static_cast<glm::length_t>(component)]);
    const QPointF way(scale().perSecond, -slope / m_axis.perPixel());
    return place + way * ((after ? kHandle : -kHandle) / std::hypot(way.x(), way.y()));
}

// --- what is under the hand ---

std::optional<KeyGraph::Hit> KeyGraph::hitAt(const QPointF& at)
{
    refresh();
    std::optional<Hit> nearest;
    double reach = kReach;
    const auto look = [&](const QPointF& place, const Hit& hit) {
        const double away = QLineF(place, at).length();
        if (away < reach) {
            reach = away;
            nearest = hit;
        }
    };
    for (const GraphCurve& curve : m_curves) {
        for (const KeyPlace& key : m_selection.keys()) {
            for (const bool after : {false, true}) {
                if (key.parameter == curve.parameter) {
                    if (const std::optional<QPointF> end = handleOf(key, after, curve.component)) {
                        look(*end, {key, curve.component, true, after});
                    }
                }
            }
        }
        for (const KeyFrame& key : m_selection.track(*curve.parameter)->keys) {
            const KeyPlace place{curve.parameter, key.seconds};
            look(placeOf(place, curve.component), {place, curve.component});
        }
    }
    return nearest;
}

const GraphCurve* KeyGraph::curveAt(const QPointF& at)
{
    refresh();
    const GraphCurve* nearest = nullptr;
    double reach = kReach;
    for (const GraphCurve& curve : m_curves) {
        const double away = std::abs(m_axis.yOf(curve.valueAt(at.x())) - at.y());
        if (away < reach) {
            reach = away;
            nearest = &curve;
        }
    }
    return nearest;
}

std::vector<KeyPlace> KeyGraph::keysIn(const QRectF& box)
{
    refresh();
    std::vector<KeyPlace> keys;
    for (const GraphCurve& curve : m_curves) {
        for (const KeyFrame& key : m_selection.track(*curve.parameter)->keys) {
            const KeyPlace place{curve.parameter, key.seconds};
            if (box.contains(placeOf(place, curve.component))) {
                keys.push_back(place);
            }
        }
    }
    return keys;
}

} // namespace fumage::ui
