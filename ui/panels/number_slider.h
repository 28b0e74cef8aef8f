#pragma once

#include "ui/widgets/gesture.h"
#include "ui/panels/number_scale.h"

#include <QSlider>

namespace fumage::ui {

/// A slider over the soft range of a number. A click goes to its place; keys and, with the focus, the wheel go by
/// steps.
class NumberSlider : public QSlider {
    Q_OBJECT

public:
    explicit NumberSlider(const NumberScale& scale, QWidget* parent = nullptr);

    /// Shows a value without telling anybody; beyond the range, the nearer end.
    void setNumber(double number);

signals:
    void edited(double value, bool finished);

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void follow(int position);

    NumberScale m_scale;
    GestureTimer m_burst;
    double m_number = 0.0;
    bool m_jumping = false; ///< a click beside the handle brings it there
};

} // namespace fumage::ui
