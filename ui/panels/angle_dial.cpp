#include "ui/panels/angle_dial.h"

#include <cmath>

#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>

#include <glm/trigonometric.hpp>

namespace fumage::ui {

namespace {

constexpr double kSnap = 15.0;

} // namespace

AngleDial::AngleDial(QWidget* parent)
    : QWidget(parent)
{
    setFixedSize(sizeHint());
    setFocusPolicy(Qt::StrongFocus);
    connect(&m_burst, &GestureTimer::ended, this, [this] { emit edited(m_angle, true); });
}

void AngleDial::setAngle(double degrees)
{
    if (degrees != m_angle) {
        m_angle = degrees;
        update();
    }
}

void AngleDial::turnTo(const QPointF& mouse, bool snap)
{
    const QPointF way = mouse - QRectF(rect()).center();
    double angle = std::round(glm::degrees(std::atan2(way.y(), way.x())));
    angle = snap ? std::round(angle / kSnap) * kSnap : angle;
    if (angle != m_angle) {
        setAngle(angle);
        emit edited(angle, false);
    }
}

void AngleDial::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        return;
    }
    m_burst.end();
    m_turning = true;
    turnTo(event->position(), event->modifiers().testFlag(Qt::ControlModifier));
}

void AngleDial::mouseMoveEvent(QMouseEvent* event)
{
    if (m_turning) {
        turnTo(event->position(), event->modifiers().testFlag(Qt::ControlModifier));
    }
}

void AngleDial::mouseReleaseEvent(QMouseEvent* event)
{
    if (m_turning && event->button() == Qt::LeftButton) {
        m_turning = false;
        emit edited(m_angle, true);
    }
}

void AngleDial::keyPressEvent(QKeyEvent* event)
{
    const bool more = event->key() == Qt::Key_Up || event->key() == Qt::Key_Right;
    const bool less = event->key() == Qt::Key_Down || event->key() == Qt::Key_Left;
    if (!more && !less) {
        QWidget::keyPressEvent(event);
        return;
    }
    setAngle(m_angle + (more ? 1.0 : -1.0));
    m_burst.start();
    emit edited(m_angle, false);
}

void AngleDial::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF disc = QRectF(rect()).adjusted(2.0, 2.0, -2.0, -2.0);
    painter.setPen(QPen(hasFocus() ? palette().highlight().color() : palette().mid().color(), 1.4));
    painter.setBrush(palette().base());
    painter.drawEllipse(disc);
    QLineF pointer(disc.center(), disc.center() + QPointF(disc.width() / 2.0 - 2.0, 0.0));
    pointer.setAngle(-m_angle);
    painter.setPen(QPen(palette().highlight().color(), 2.4, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(pointer);
}

} // namespace fumage::ui
