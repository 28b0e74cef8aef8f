#include "ui/timeline/ease_icon.h"

#include <QPainter>
#include <QPainterPath>

namespace fumage::ui {

QIcon easeIcon(Ease ease, const QColor& colour)
{
    constexpr int kSize = 32;
    QPixmap pixmap(kSize, kSize);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, 2.5));
    QPainterPath path(QPointF(4.0, 28.0));
    switch (ease) {
    case Ease::Auto:
    case Ease::Free: path.cubicTo(QPointF(16.0, 28.0), QPointF(16.0, 4.0), QPointF(28.0, 4.0)); break;
    case Ease::Linear: path.lineTo(QPointF(28.0, 4.0)); break;
    case Ease::Hold:
        path.lineTo(QPointF(28.0, 28.0));
        path.lineTo(QPointF(28.0, 4.0));
        break;
    }
    painter.drawPath(path);
    return QIcon(pixmap);
}

} // namespace fumage::ui
