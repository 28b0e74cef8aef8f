#pragma once

#include <QWidget>

#include <optional>

namespace fumage::ui {

/// The edge between lanes and graph: the hand drags it up and down, and a double-click puts it back.
class GraphGrip : public QWidget {
    Q_OBJECT

public:
    explicit GraphGrip(QWidget* parent);

    static constexpr int kThickness = 6; ///< pixels
    QSize sizeHint() const override { return {400, kThickness}; }

signals:
    void pressed();
    /// @param way pixels down since it was pressed, whatever has moved meanwhile
    void dragged(int way);
    void doubleClicked();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    std::optional<double> m_from; ///< where the drag began, pixels of the screen
};

} // namespace fumage::ui
