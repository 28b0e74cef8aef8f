#pragma once

#include "ui/panels/parameter_editor.h"
#include "ui/panels/point_strip.h"

namespace fumage::ui {

/// The drawing area of a curve, whose points go sideways and up and down.
class CurveArea : public PointStrip {
    Q_OBJECT

public:
    explicit CurveArea(QWidget* parent);

    void setCurve(const Curve& curve);
    [[nodiscard]] const Curve& curve() const { return m_curve; }
    [[nodiscard]] QPointF toScreen(const CurvePoint& point) const;
    QSize sizeHint() const override { return {200, 96}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    [[nodiscard]] int count() const override { return m_curve.count; }
    [[nodiscard]] int pointAt(const QPointF& mouse) const override;
    int insertAt(const QPointF& mouse) override { return insert(fromScreen(mouse)); }
    int insertAfter(int index) override;
    void moveTo(int index, const QPointF& mouse) override { place(index, fromScreen(mouse)); }
    bool step(int index, int right, int up) override;
    void erase(int index) override { removePoint(m_curve, index); }

private:
    [[nodiscard]] QRectF area() const;
    [[nodiscard]] CurvePoint fromScreen(const QPointF& at) const;
    int insert(const CurvePoint& point);
    /// Between its neighbours, rounded as a person would write it.
    void place(int index, CurvePoint to);

    Curve m_curve;
};

class CurveEditor : public ParameterEditor {
    Q_OBJECT

public:
    CurveEditor(const Parameter& parameter, QWidget* parent);
    void setValue(const Value& value) override;
    void addActions(QMenu& menu, const QPoint& global) override { m_area->addActions(menu, global); }

private:
    CurveArea* m_area;
};

} // namespace fumage::ui
