#include "ui/timeline/graph_grip.h"

#include "ui/widgets/gesture.h"

#include <QMouseEvent>
#include <QPainter>

#include <cmath>

namespace fumage::ui {

GraphGrip::GraphGrip(QWidget* parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("graphGrip"));
    setAccessibleName(tr("Height of the graph"));
    setToolTip(tr("Drag for a higher graph; a double-click gives it its usual height"));
    setCursor(Qt::SizeVerCursor);
    setFixedHeight(kThickness);
}

bool GraphGrip::event(QEvent* event)
{
    if (event->type() == DragCancel::type() && m_from) {
        m_from.reset();
        emit dragged(0); // as high as it was
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void GraphGrip::paintEvent(QPaintEvent* /*event*/)
{
    constexpr double kLength = 36.0; // pixels
    constexpr double kWidth = 2.0;
    QPainter painter(this);
    painter.fillRect(
        QRectF(0.5 * (width() - kLength), 0.5 * (height() - kWidth), kLength, kWidth), palette().mid().color());
}

void GraphGrip::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) {
        m_from = event->globalPosition().y();
        emit pressed();
    }
}

void GraphGrip::mouseMoveEvent(QMouseEvent* event)
{
    if (m_from) {
        emit dragged(static_cast<int>(std::lround(event->globalPosition().y() - *m_from)));
    }
}

void GraphGrip::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) {
        m_from.reset();
    }
}

void GraphGrip::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) {
        emit doubleClicked();
    }
}

} // namespace fumage::ui
