#pragma once

#include <QPainter>

namespace fumage::ui {

/// Paints the mark of a key frame about a point.
/// @param radius pixels
inline void paintDiamond(QPainter& painter, const QPointF& centre, double radius, const QColor& colour, bool filled)
{
    constexpr double kLine = 1.2;
    painter.setPen(QPen(colour, kLine));
    painter.setBrush(filled ? QBrush(colour) : QBrush(Qt::NoBrush));
    painter.drawPolygon(QPolygonF{centre + QPointF(0.0, -radius), centre + QPointF(radius, 0.0),
        centre + QPointF(0.0, radius), centre + QPointF(-radius, 0.0)});
}

} // namespace fumage::ui
