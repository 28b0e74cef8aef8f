#pragma once

#include "core/effect/gradient.h"

#include <algorithm>

#include <QWidget>

class QMenu;

namespace fumage::ui {

/// Points along a strip, in order, for the hand: press one to drag it, press beside them for a new one, take one away
/// with Delete or from its menu, go from one to the next with PageUp and PageDown, move one with the arrows. What a
/// point is and how it looks says the class derived from it.
class PointStrip : public QWidget {
    Q_OBJECT

public:
    explicit PointStrip(QWidget* parent);

    /// What a menu offers for the point that lies at a place on the screen; nothing where there is none.
    void addActions(QMenu& menu, const QPoint& global);

signals:
    /// The hand has changed the points.
    /// @param finished the gesture is over
    void changed(bool finished);

protected:
    static constexpr float kStep = 0.01F; ///< of an arrow key, of the whole strip
    static constexpr float kBeside = 0.1F; ///< from a point to one that is inserted after it

    [[nodiscard]] virtual int count() const = 0;
    /// @return the index of the point under the mouse; -1: none
    [[nodiscard]] virtual int pointAt(const QPointF& mouse) const = 0;
    /// A new point under the mouse, or a little after another. @return its index; -1 where there is no room
    virtual int insertAt(const QPointF& mouse) = 0;
    virtual int insertAfter(int index) = 0;
    virtual void moveTo(int index, const QPointF& mouse) = 0;
    /// @param right,up -1, 0 or 1
    /// @return whether a point goes that way
    virtual bool step(int index, int right, int up) = 0;
    virtual void erase(int index) = 0;
    /// What a menu offers for one point, before it can be taken away there.
    virtual void addPointActions(QMenu&, int) { }

    /// The points may be exchanged: the hand does not hold one.
    [[nodiscard]] bool isFree() const { return !m_dragging; }
    /// Other points are there.
    void pointsReplaced() { select(m_selected); }
    /// What began as a drag is none.
    void letGo() { m_dragging = false; }
    [[nodiscard]] int selected() const { return m_selected; }
    /// Selected, and the keys go to it.
    [[nodiscard]] bool isMarked(int index) const { return index == m_selected && hasFocus(); }

    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void select(int index);
    /// The point with this index has come or moved.
    void touched(int index, bool finished);
    void remove(int index);

    int m_selected = 0;
    bool m_dragging = false;
};

[[nodiscard]] inline float placeOf(const CurvePoint& point)
{
    return point.x;
}
[[nodiscard]] inline float placeOf(const GradientStop& stop)
{
    return stop.at;
}

/// Puts a point among those of a Curve or a Gradient, after the ones at the same place.
/// @return its index; -1 where there is no room
template <class Points, class Point>
int insertPoint(Points& points, const Point& point)
{
    if (points.count == kMaxControlPoints) {
        return -1;
    }
    const auto begin = points.storage.begin();
    const auto end = begin + points.count;
    const auto at =
        std::upper_bound(begin, end, point, [](const Point& a, const Point& b) { return placeOf(a) < placeOf(b); });
    std::copy_backward(at, end, end + 1);
    *at = point;
    ++points.count;
    return static_cast<int>(at - begin);
}

/// Takes one away; what is behind the last is as new, for effects are compared whole.
template <class Points>
void removePoint(Points& points, int index)
{
    const auto at = points.storage.begin() + index;
    std::copy(at + 1, points.storage.begin() + points.count, at);
    --points.count;
    points.storage[static_cast<std::size_t>(points.count)] = {};
}

} // namespace fumage::ui
