#pragma once

#include "ui/widgets/gesture.h"
#include "ui/panels/number_scale.h"

#include <QLineEdit>

namespace fumage::ui {

/// A number that can be dragged sideways, typed with its unit, stepped with the arrow keys, and with the wheel while it
/// has the focus. Shift moves finely, Ctrl snaps to tens of steps. Return takes over what was typed, Escape puts back
/// what was there, and both leave the field.
class NumberField : public QLineEdit {
    Q_OBJECT

public:
    explicit NumberField(const NumberScale& scale, QWidget* parent = nullptr);

    [[nodiscard]] double value() const { return m_value; }
    /// Shows a value without telling anybody; leaves alone what is being typed.
    void setValue(double value);

    QSize sizeHint() const override;

signals:
    /// @param finished the gesture is over: released, typed, or no more wheel for a moment
    void edited(double value, bool finished);

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void showValue();
    [[nodiscard]] QString fittingText() const;
    void commitText();
    void stepBy(double steps);

    NumberScale m_scale;
    double m_value = 0.0;
    GestureTimer m_burst;
    bool m_pressed = false;
    bool m_dragged = false;
    EndlessWay m_way{Qt::Horizontal};
    double m_valueAtPress = 0.0;
};

} // namespace fumage::ui
