#pragma once

#include "ui/panels/parameter_editor.h"
#include "ui/panels/point_strip.h"

namespace fumage::ui {

/// The bar of a gradient with its stops below, which go sideways; a double click or Return colours one.
class GradientBar : public PointStrip {
    Q_OBJECT

public:
    explicit GradientBar(QWidget* parent);

    void setGradient(const Gradient& gradient);
    [[nodiscard]] const Gradient& gradient() const { return m_gradient; }
    /// Takes over another gradient in one step of the hand.
    void replace(const Gradient& gradient);
    [[nodiscard]] QPointF handle(int stop) const;
    QSize sizeHint() const override { return {200, 40}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    [[nodiscard]] int count() const override { return m_gradient.count; }
    [[nodiscard]] int pointAt(const QPointF& mouse) const override;
    int insertAt(const QPointF& mouse) override { return insert(positionOf(mouse)); }
    int insertAfter(int index) override;
    void moveTo(int index, const QPointF& mouse) override { place(index, positionOf(mouse)); }
    bool step(int index, int right, int up) override;
    void erase(int index) override { removePoint(m_gradient, index); }
    void addPointActions(QMenu& menu, int index) override;

private:
    [[nodiscard]] QRectF bar() const;
    [[nodiscard]] float positionOf(const QPointF& mouse) const;
    /// In the colour that the gradient has there.
    int insert(float at) { return insertPoint(m_gradient, GradientStop{at, m_gradient.at(at)}); }
    /// Between its neighbours.
    void place(int index, float at);
    void colourStop(int stop);

    Gradient m_gradient;
};

class GradientEditor : public ParameterEditor {
    Q_OBJECT

public:
    GradientEditor(const Parameter& parameter, QWidget* parent);
    void setValue(const Value& value) override;
    void addActions(QMenu& menu, const QPoint& global) override;

private:
    /// What can be done with the gradient as a whole.
    void fillMenu(QMenu& menu);

    GradientBar* m_bar;
};

} // namespace fumage::ui
