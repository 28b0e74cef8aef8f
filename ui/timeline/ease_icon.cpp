#include "ui/timeline/ease_icon.h"

#include <QPainter>
#include <QPainterPath>

namespace fumage::ui {

namespace {

constexpr double kLine = 2.5;
constexpr double kDot = 3.0;

/// An icon that a function paints, on a square of 32 pixels.
template <class Paint>
QIcon painted(const QColor& colour, const Paint& paint)
{
    constexpr int kSize = 32;
    QPixmap pixmap(kSize, kSize);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, kLine));
    paint(painter);
    painter.end();
    return QIcon(pixmap);
}

void paintHandle(QPainter& painter, const QPointF& key, const QPointF& end)
{
    painter.setPen(QPen(painter.pen().color(), 1.0));
    painter.drawLine(QLineF(key, end));
    painter.setBrush(painter.pen().color());
    painter.drawEllipse(end, kDot, kDot);
}

} // namespace

QIcon easeIcon(Ease ease, const QColor& colour)
{
    return painted(colour, [ease](QPainter& painter) {
        QPainterPath path(QPointF(4.0, 28.0));
        switch (ease) {
        case Ease::Auto: path.cubicTo(QPointF(16.0, 28.0), QPointF(16.0, 4.0), QPointF(28.0, 4.0)); break;
        case Ease::Free: path.cubicTo(QPointF(8.0, 4.0), QPointF(20.0, 20.0), QPointF(28.0, 4.0)); break;
        case Ease::Linear: path.lineTo(QPointF(28.0, 4.0)); break;
        case Ease::Hold:
            path.lineTo(QPointF(28.0, 28.0));
            path.lineTo(QPointF(28.0, 4.0));
            break;
        }
        painter.drawPath(path);
        if (ease == Ease::Free) {
            paintHandle(painter, QPointF(4.0, 28.0), QPointF(8.0, 6.0));
        }
    });
}

QIcon levelIcon(bool in, bool out, const QColor& colour)
{
    return painted(colour, [in, out](QPainter& painter) {
        const QPointF key(16.0, 16.0);
        QPainterPath path(QPointF(4.0, 28.0));
        path.cubicTo(QPointF(6.0, 22.0), in ? QPointF(8.0, 16.0) : QPointF(12.0, 20.0), key);
        path.cubicTo(out ? QPointF(24.0, 16.0) : QPointF(20.0, 12.0), QPointF(26.0, 10.0), QPointF(28.0, 4.0));
        painter.drawPath(path);
        painter.setBrush(painter.pen().color());
        painter.drawEllipse(key, kDot, kDot);
    });
}

} // namespace fumage::ui
