#pragma once

#include "ui/timeline/graph_curves.h"
#include "ui/timeline/key_selection.h"
#include "ui/timeline/player.h"
#include "ui/widgets/gesture.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace fumage::ui {

class TimelineRuler;

/// The curves of parameters that change over time, over an axis of values and in line with the ruler.
///
/// Keys are chosen by a click or a box and dragged in time and value: Shift keeps to one of both, Alt stretches times.
/// The handles of a key that is selected set its slopes, both together, with Ctrl one alone. A double-click on a curve
/// adds a key and leaves the curve as it is. The wheel zooms the values, the middle button moves them, F and a
/// double-click on their axis show all. Arrows move what is selected by a frame or a step of the value. Curves are
/// sampled when they are painted, once for each change and width.
class KeyGraph : public QWidget {
    Q_OBJECT

public:
    /// @param ruler     that says where a frame lies
    /// @param selection that it shares with the lanes
    KeyGraph(Document& document, Player& player, const TimelineRuler& ruler, KeySelection& selection, QWidget* parent);

    /// Where a key frame is painted.
    /// @param component of its value: see componentCount()
    [[nodiscard]] QPointF placeOf(const KeyPlace& key, std::size_t component = 0);
    /// Where the end of a handle is painted; nothing: the key has none on that side.
    [[nodiscard]] std::optional<QPointF> handleOf(const KeyPlace& key, bool after, std::size_t component = 0);
    /// The axis of values.
    [[nodiscard]] const ValueAxis& axis();
    /// The curves that are shown.
    [[nodiscard]] const std::vector<GraphCurve>& curves();
    /// Fits the axis to the curves.
    void frameAll();

    static constexpr int kHeight = 160; ///< pixels, where nobody has chosen another
    static constexpr int kMinHeight = 80;
    static constexpr int kMaxHeight = 400;
    QSize sizeHint() const override { return {400, kHeight}; }

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    enum class Drag {
        None,
        Keys,
        Handle,
        Box,
        Pan,
    };
    /// What lies under the hand.
    struct Hit {
        KeyPlace key;
        std::size_t component = 0;
        bool isHandle = false;
        bool isAfter = false; ///< of a handle
    };
    void forget();
    void follow();
    void refresh();
    void fit();
    [[nodiscard]] double frameRate() const;
    [[nodiscard]] TimeScale scale() const;
    [[nodiscard]] double frameSecondsAt(double x) const;
    [[nodiscard]] std::optional<Hit> hitAt(const QPointF& at);
    [[nodiscard]] const GraphCurve* curveAt(const QPointF& at);
    [[nodiscard]] std::vector<KeyPlace> keysIn(const QRectF& box);
    void begin(const Hit& hit, Qt::KeyboardModifiers modifiers);
    void dragKeys(Qt::KeyboardModifiers modifiers);
    void dragHandle(bool breaks);
    void takeBack();
    void nudge(int frames, int steps);
    [[nodiscard]] bool wants(const QKeyEvent& event) const;

    void paintGrid(QPainter& painter) const;
    void paintCurve(QPainter& painter, const GraphCurve& curve) const;
    void paintKeys(QPainter& painter, const GraphCurve& curve);
    void paintHandles(QPainter& painter, const GraphCurve& curve, const KeyPlace& key);
    void paintNames(QPainter& painter) const;
    [[nodiscard]] QColor colourOf(const GraphCurve& curve) const;

    Document& m_document;
    Player& m_player;
    const TimelineRuler& m_ruler;
    KeySelection& m_selection;
    ValueAxis m_axis;
    std::vector<GraphCurve> m_curves;
    std::vector<const Parameter*> m_shown; ///< whose curves they are
    bool m_isStale = true; ///< the curves have to be sampled
    bool m_isFitted = false; ///< the axis shows all, nobody has moved it
    Drag m_drag = Drag::None;
    QPointF m_press;
    QPointF m_at;
    bool m_hasMoved = false;
    Hit m_grip; ///< what is dragged
    QPointF m_offset; ///< of a handle's end from the hand
    Gesture m_gesture;
    std::vector<Track> m_base; ///< before the gesture
    std::vector<KeyPlace> m_dragged; ///< those that were selected at the press
    ValueAxis m_axisBefore; ///< the gesture
    std::size_t m_component = 0; ///< that was dragged last: arrows change it
    GestureTimer m_nudges;
    Gesture m_nudge;
};

} // namespace fumage::ui
