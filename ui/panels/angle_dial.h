#pragma once

#include "ui/widgets/gesture.h"

#include <QWidget>

namespace fumage::ui {

/// A small round dial for an angle that goes all around; 0 points right, angles grow downwards as seen from above (+Z
/// towards the viewer).
class AngleDial : public QWidget {
    Q_OBJECT

public:
    explicit AngleDial(QWidget* parent = nullptr);

    void setAngle(double degrees);
    QSize sizeHint() const override { return {28, 28}; }

signals:
    void edited(double degrees, bool finished);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void turnTo(const QPointF& mouse, bool snap);

    double m_angle = 0.0;
    bool m_turning = false;
    GestureTimer m_burst;
};

} // namespace fumage::ui
