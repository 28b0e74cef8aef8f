#include "ui/viewport/gizmo_painter.h"

#include "ui/viewport/overlays.h"

#include <algorithm>
#include <iterator>

#include <QLineF>
#include <QPainter>

#include <glm/geometric.hpp>

namespace fumage::ui {

namespace {

void paintArrow(QPainter& painter, const QLineF& line, const QColor& colour, bool hot)
{
    constexpr double kThin = 1.6;
    constexpr double kThick = 3.0;
    constexpr double kHead = 11.0;
    constexpr double kHeadAngle = 24.0;
    painter.setPen(QPen(QColor(0, 0, 0, 110), kThick + 1.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(line);
    painter.setPen(QPen(colour, hot ? kThick : kThin, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(line);
    if (line.length() < kHead) {
        painter.setBrush(colour);
        painter.drawEllipse(line.p2(), 5.0, 5.0);
        return;
    }
    QLineF side(line.p2(), line.p1());
    side.setLength(kHead);
    QPolygonF head{line.p2()};
    for (const double turn : {kHeadAngle, -2.0 * kHeadAngle}) {
        side.setAngle(side.angle() + turn);
        head << side.p2();
    }
    painter.setBrush(colour);
    painter.drawPolygon(head);
}

void paintHandle(QPainter& painter, QPointF at, const QColor& colour, bool hot)
{
    constexpr double kRadius = 5.0;
    painter.setPen(QPen(QColor(0, 0, 0, 140), 1.0));
    painter.setBrush(hot ? colour.lighter() : colour);
    painter.drawEllipse(at, kRadius, kRadius);
}

void paintSun(QPainter& painter, QPointF at, const QColor& colour, bool hot)
{
    constexpr int kRays = 8;
    constexpr double kDisc = 6.0;
    constexpr double kRayEnd = 12.0;
    painter.setPen(QPen(colour, hot ? 2.4 : 1.6, Qt::SolidLine, Qt::RoundCap));
    for (int i = 0; i < kRays; ++i) {
        QLineF ray(at, at + QPointF(kRayEnd, 0.0));
        ray.setAngle(360.0 * i / kRays);
        painter.drawLine(ray.pointAt(0.75), ray.p2());
    }
    painter.setBrush(colour);
    painter.drawEllipse(at, kDisc, kDisc);
}

/// A label that waits until all lines are drawn, so that none crosses it.
struct Label {
    QRectF place;
    QString text;
    QColor colour;
};

/// Where a label stands: beyond the end of its line, and not where another one is.
QRectF placeOfLabel(const QFontMetrics& metrics, const QLineF& line, const QString& text, int viewWidth,
    const std::vector<Label>& others)
{
    constexpr double kGap = 14.0;
    constexpr double kPadding = 4.0;
    const double width = metrics.horizontalAdvance(text) + 2.0 * kPadding;
    const double beside = line.dx() < -0.5 * line.length() ? -kGap - width : kGap;
    const double most = viewWidth - width - kPadding;
    const QPointF wanted(std::min(line.p2().x() + beside, most), line.p2().y() + 4.0 - metrics.ascent());
    std::vector<QRectF> taken;
    std::transform(
        others.begin(), others.end(), std::back_inserter(taken), [](const Label& label) { return label.place; });
    return freePlace({wanted.x(), wanted.y(), width, metrics.height() + 1.0}, taken);
}

/// On a dark plate: readable on any smoke and any background.
void paintLabel(QPainter& painter, const Label& label, bool hot)
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(18, 20, 24, hot ? 220 : 170));
    painter.drawRoundedRect(label.place, 4.0, 4.0);
    constexpr int kPale = 130;
    painter.setPen(label.colour.lighter(kPale));
    painter.drawText(label.place, Qt::AlignCenter, label.text);
}

/// @return whether the gizmo is one that has a label
bool paintGizmo(
    QPainter& painter, const Gizmo& gizmo, const QLineF& line, const Effect& effect, const View& view, bool hot)
{
    if (gizmo.id == GizmoId::Light) {
        painter.setPen(
            QPen(QColor(gizmo.colour.red(), gizmo.colour.green(), gizmo.colour.blue(), 90), 1.0, Qt::DashLine));
        painter.drawLine(line);
        paintSun(painter, line.p2(), gizmo.colour, hot);
    } else if (gizmo.label.isEmpty() || gizmo.id == GizmoId::EmitterPosition) {
        paintHandle(painter, line.p2(), gizmo.colour, hot);
        return false;
    } else if (gizmo.id == GizmoId::ObstacleSize || gizmo.id == GizmoId::AirSize) {
        paintHandle(painter, line.p2(), gizmo.colour, hot);
    } else if (gizmo.id == GizmoId::Rings) {
        painter.setPen(
            QPen(QColor(gizmo.colour.red(), gizmo.colour.green(), gizmo.colour.blue(), 150), hot ? 2.0 : 1.2));
        paintCircle(
            painter, gizmo.from, glm::normalize(effect.emitter.normal), glm::distance(gizmo.from, gizmo.to), view);
        paintHandle(painter, line.p2(), gizmo.colour, hot);
    } else {
        paintArrow(painter, line, gizmo.colour, hot);
    }
    return true;
}

} // namespace

QRectF freePlace(QRectF wanted, const std::vector<QRectF>& taken)
{
    for (std::size_t tries = 0; tries < taken.size(); ++tries) {
        const auto meets = [&](const QRectF& other) { return other.intersects(wanted); };
        const auto other = std::find_if(taken.begin(), taken.end(), meets);
        if (other == taken.end()) {
            break;
        }
        wanted.moveTop(other->bottom());
    }
    return wanted;
}

void paintGizmos(QPainter& painter, const Effect& effect, const View& view, std::optional<GizmoId> hot)
{
    std::vector<Label> labels;
    std::optional<std::size_t> hotLabel;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Gizmo& gizmo : gizmosOf(effect, view)) {
        const std::optional<QLineF> line = projectLine(view, gizmo.from, gizmo.to);
        if (line && paintGizmo(painter, gizmo, *line, effect, view, hot == gizmo.id)) {
            hotLabel = hot == gizmo.id ? std::optional(labels.size()) : hotLabel;
            labels.push_back({placeOfLabel(painter.fontMetrics(), *line, gizmo.label, view.width, labels), gizmo.label,
                gizmo.colour});
        }
    }
    for (std::size_t i = 0; i < labels.size(); ++i) {
        paintLabel(painter, labels[i], hotLabel == i);
    }
    painter.restore();
}

} // namespace fumage::ui
