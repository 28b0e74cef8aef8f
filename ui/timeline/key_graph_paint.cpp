#include "ui/timeline/key_graph.h"

#include "ui/document/parameter_text.h"
#include "ui/timeline/timeline_marks.h"
#include "ui/timeline/timeline_ruler.h"
#include "ui/widgets/diamond.h"

#include <QPainter>

#include <algorithm>
#include <array>

namespace fumage::ui {

namespace {

constexpr double kRadius = 4.5; ///< of a key, pixels
constexpr double kDot = 3.0; ///< of the end of a handle

/// What stands at a tick of the only curve of choices or switches; empty: between them.
QString stepText(const Parameter& parameter, double value)
{
    const auto index = static_cast<std::size_t>(std::max(0.0, value));
    if (value < 0.0 || static_cast<double>(index) != value) {
        return {};
    }
    if (parameter.kind == Kind::Choice) {
        return index < parameter.choices.size() ? choiceLabelOf(parameter.choices[index]) : QString();
    }
    return parameter.kind == Kind::Bool && index < 2 ? (index == 1 ? KeyGraph::tr("on") : KeyGraph::tr("off"))
                                                     : QString();
}

/// The unit of the axis: none where curves of several share it.
Unit commonUnit(const std::vector<const Parameter*>& parameters)
{
    const bool isCommon = std::all_of(parameters.begin(), parameters.end(),
        [&](const Parameter* parameter) { return parameter->unit == parameters.front()->unit; });
    return isCommon && !parameters.empty() ? parameters.front()->unit : Unit::None;
}

} // namespace

QColor KeyGraph::colourOf(const GraphCurve& curve) const
{
    return curve.colour.isValid() ? curve.colour : palette().highlight().color();
}

void KeyGraph::paintGrid(QPainter& painter) const
{
    QColor line = palette().text().color();
    QColor text = line;
    constexpr int kFaint = 30;
    constexpr int kText = 170;
    line.setAlpha(kFaint);
    text.setAlpha(kText);
    const int frames = m_ruler.tickStep();
    painter.setPen(line);
    for (int frame = 0; frame < m_player.length(); frame += frames) {
        painter.drawLine(QLineF(m_ruler.xOf(frame), 0.0, m_ruler.xOf(frame), height()));
    }
    const bool isStepped = m_shown.size() == 1 && !isRaised(m_shown.front()->kind);
    const double step = isStepped ? std::max(1.0, m_axis.tickStep()) : m_axis.tickStep();
    const Unit unit = commonUnit(m_shown);
    for (const double value : roundTicks(m_axis.low, m_axis.high, step)) {
        const double y = m_axis.yOf(value);
        painter.setPen(line);
        painter.drawLine(QLineF(0.0, y, width(), y));
        painter.setPen(text);
        constexpr double kHigh = 14.0;
        painter.drawText(QRectF(3.0, y - kHigh, width(), kHigh), Qt::AlignLeft | Qt::AlignBottom,
            isStepped ? stepText(*m_shown.front(), value) : tickText(value, step, unit));
    }
}

void KeyGraph::paintCurve(QPainter& painter, const GraphCurve& curve) const
{
    // Far outside a line costs as much as it is long, above all where it is dashed.
    const auto placeOf = [&](const GraphPoint& point) {
        return QPointF(point.x, std::clamp<double>(m_axis.yOf(point.value), -height(), 2.0 * height()));
    };
    std::array<QPolygonF, 3> parts; // before, among and after the keys
    for (const GraphPoint& point : curve.points) {
        const QPointF place = placeOf(point);
        if (point.x <= curve.first) {
            parts[0] << place;
        }
        if (point.x >= curve.first && point.x <= curve.last) {
            parts[1] << place;
        }
        if (point.x >= curve.last) {
            parts[2] << place;
        }
    }
    const QColor colour = colourOf(curve);
    constexpr double kLine = 1.5;
    for (std::size_t part = 0; part < parts.size(); ++part) {
        painter.setPen(QPen(colour, kLine, part == 1 ? Qt::SolidLine : Qt::DashLine));
        painter.drawPolyline(parts[part]);
    }
}

void KeyGraph::paintHandles(QPainter& painter, const GraphCurve& curve, const KeyPlace& key)
{
    const QColor colour = palette().text().color();
    for (const bool after : {false, true}) {
        if (const std::optional<QPointF> end = handleOf(key, after, curve.component)) {
            painter.setPen(QPen(colour, 1.0));
            painter.drawLine(QLineF(placeOf(key, curve.component), *end));
            painter.setBrush(colour);
            painter.drawEllipse(*end, kDot, kDot);
        }
    }
}

void KeyGraph::paintKeys(QPainter& painter, const GraphCurve& curve)
{
    const Track* track = m_selection.track(*curve.parameter);
    for (const KeyFrame& key : track != nullptr ? track->keys : std::vector<KeyFrame>()) {
        const KeyPlace place{curve.parameter, key.seconds};
        const bool isSelected = m_selection.contains(place);
        if (isSelected) {
            paintHandles(painter, curve, place);
        }
        paintDiamond(painter, placeOf(place, curve.component), kRadius,
            isSelected ? palette().highlight().color() : palette().text().color(), true);
    }
}

void KeyGraph::paintNames(QPainter& painter) const
{
    constexpr double kHigh = 15.0;
    double top = 2.0;
    for (const GraphCurve& curve : m_curves) {
        painter.setPen(colourOf(curve));
        painter.drawText(QRectF(0.0, top, width() - 6.0, kHigh), Qt::AlignRight | Qt::AlignVCenter, curve.name);
        top += kHigh;
    }
}

void KeyGraph::paintEvent(QPaintEvent*)
{
    refresh();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    paintGrid(painter);
    for (const GraphCurve& curve : m_curves) {
        paintCurve(painter, curve);
    }
    for (const GraphCurve& curve : m_curves) {
        paintKeys(painter, curve);
    }
    paintNames(painter);
    const double x = m_ruler.xOf(m_player.frame());
    paintPlayhead(painter, *this, x);
    if (m_drag == Drag::Box && m_hasMoved) {
        paintSelectionBox(painter, *this, QRectF(m_press, m_at).normalized());
    }
}

} // namespace fumage::ui
