#pragma once

#include "ui/panels/parameter_editor.h"

namespace fumage::ui {

/// The drawing area of a curve: points can be dragged, added with a click and taken away with Delete or the right button.
class CurveArea : public QWidget {
    Q_OBJECT

public:
    explicit CurveArea(QWidget* parent);

    void setCurve(const Curve& curve);
    [[nodiscard]] const Curve& curve() const { return m_curve; }
    [[nodiscard]] QPointF toScreen(const CurvePoint& point) const;
    QSize sizeHint() const override { return {200, 96}; }

signals:
    void edited(const fumage::Curve& curve, bool finished);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] QRectF area() const;
    [[nodiscard]] CurvePoint fromScreen(const QPointF& at) const;
    [[nodiscard]] int pointAt(const QPointF& at) const;
    void insert(const CurvePoint& point);
    void remove(int index);
    void movePoint(int index, CurvePoint to);

    Curve m_curve;
    int m_selected = 0;
    bool m_dragging = false;
};

class CurveEditor : public ParameterEditor {
    Q_OBJECT

public:
    CurveEditor(const Parameter& parameter, QWidget* parent);
    void setValue(const Value& value) override;

private:
    CurveArea* m_area;
};

} // namespace fumage::ui
