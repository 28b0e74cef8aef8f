#include "ui/viewport/split_view.h"

#include <algorithm>
#include <cmath>

namespace fumage::ui {

bool SplitView::isAtLine(double x, int width) const
{
    constexpr double kReach = 8.0;
    return m_mode == Compare::Split && std::abs(x - lineX(width)) < kReach;
}

void SplitView::moveLine(double x, int width)
{
    constexpr double kMinShare = 0.02;
    m_line = std::clamp(x / std::max(1, width), kMinShare, 1.0 - kMinShare);
}

void SplitView::paint(QPainter& painter, const QImage& other, const QRect& area) const
{
    if (m_mode == Compare::Off) {
        return;
    }
    const double left = m_mode == Compare::Split ? lineX(area.width()) : 0.0;
    painter.save();
    painter.setClipRect(QRectF(left, 0.0, area.width() - left, area.height()));
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(area, other);
    painter.restore();
    if (m_mode == Compare::Split) {
        painter.setPen(QPen(QColor(255, 255, 255, 200), 2.0));
        painter.drawLine(QLineF(left, 0.0, left, area.height()));
        painter.drawText(QRectF(left - 28.0, 10.0, 20.0, 20.0), Qt::AlignCenter, QStringLiteral("A"));
    }
    painter.setPen(QColor(255, 255, 255, 220));
    painter.drawText(QRectF(left + 8.0, 10.0, 20.0, 20.0), Qt::AlignCenter, QStringLiteral("B"));
}

} // namespace fumage::ui
