#pragma once

#include "ui/panels/parameter_editor.h"

namespace fumage::ui {

/// The bar of a gradient with its stops below: drag them, click the bar to add one, double-click to colour it, Delete to take it away.
class GradientBar : public QWidget {
    Q_OBJECT

public:
    explicit GradientBar(QWidget* parent);

    void setGradient(const Gradient& gradient);
    [[nodiscard]] const Gradient& gradient() const { return m_gradient; }
    [[nodiscard]] QPointF handle(int stop) const;
    QSize sizeHint() const override { return {200, 40}; }

signals:
    void edited(const fumage::Gradient& gradient, bool finished);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] QRectF bar() const;
    [[nodiscard]] float positionOf(const QPointF& at) const;
    [[nodiscard]] int stopAt(const QPointF& at) const;
    void insert(float at);
    void remove(int stop);
    void moveStop(int stop, float at);
    void colourStop(int stop);

    Gradient m_gradient;
    int m_selected = 0;
    bool m_dragging = false;
};

class GradientEditor : public ParameterEditor {
    Q_OBJECT

public:
    GradientEditor(const Parameter& parameter, QWidget* parent);
    void setValue(const Value& value) override;

private:
    GradientBar* m_bar;
};

} // namespace fumage::ui
