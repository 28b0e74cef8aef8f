#pragma once

#include <QImage>
#include <QPainter>

namespace fumage::ui {

/// How another effect, B, is shown with the document's, A.
enum class Compare {
    Off,
    Split, ///< B to the right of a line that can be dragged
    Other, ///< B alone
};

/// What of the viewport shows B, and the line between the two.
class SplitView {
public:
    [[nodiscard]] Compare mode() const { return m_mode; }
    void setMode(Compare mode) { m_mode = mode; }

    /// Whether the mouse at a place across can grip the line.
    [[nodiscard]] bool isAtLine(double x, int width) const;
    void moveLine(double x, int width);

    /// Paints B over its part of the area, and the line.
    void paint(QPainter& painter, const QImage& other, const QRect& area) const;

private:
    [[nodiscard]] double lineX(int width) const { return m_line * width; }

    Compare m_mode = Compare::Off;
    double m_line = 0.5; ///< share of the width
};

} // namespace fumage::ui
