#pragma once

#include <QPainter>
#include <QWidget>

namespace fumage::ui {

// What lanes and graph of the timeline paint alike.

/// The line of the frame that is shown, over the height of a widget.
/// @param x where it is, pixels
inline void paintPlayhead(QPainter& painter, const QWidget& widget, double x)
{
    painter.setPen(QPen(widget.palette().highlight().color(), 1.0));
    painter.drawLine(QLineF(x, 0.0, x, widget.height()));
}

/// The box that chooses what lies in it.
inline void paintSelectionBox(QPainter& painter, const QWidget& widget, const QRectF& box)
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(widget.palette().highlight().color(), 1.0, Qt::DashLine));
    painter.drawRect(box);
}

} // namespace fumage::ui
