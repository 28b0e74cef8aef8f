#pragma once

#include "ui/timeline/key_selection.h"
#include "ui/timeline/player.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace fumage::ui {

class TimelineRuler;

/// The key frames of the layer that is edited and of what all layers share, a lane a parameter, under the ruler and in
/// line with it. Keys are chosen by a click or a box, dragged to other frames, stretched with Alt, removed by Delete,
/// copied and pasted at the time that is shown. It takes no room where nothing changes over time.
class KeyLanes : public QWidget {
    Q_OBJECT

public:
    /// @param ruler that says where a frame lies
    /// @param selection that it shares with the graph
    KeyLanes(Document& document, Player& player, const TimelineRuler& ruler, KeySelection& selection, QWidget* parent);

    [[nodiscard]] const std::vector<KeyPlace>& selected() const { return m_selection.keys(); }
    /// Whether lanes are marked whose curves the graph shows.
    void setMarksShown(bool marks);
    /// Where a key frame is painted.
    [[nodiscard]] QPointF placeOf(const KeyPlace& key) const;

    QSize sizeHint() const override;

    static constexpr int kLaneHeight = 18; ///< pixels

signals:
    /// There are more lanes, or fewer.
    void heightChanged();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    enum class Drag {
        None,
        Keys,
        Box,
    };
    void fitHeight();
    [[nodiscard]] double frameRate() const;
    [[nodiscard]] double secondsAt(double x) const;
    [[nodiscard]] const Track* trackAt(double y) const;
    [[nodiscard]] std::optional<KeyPlace> keyUnder(const QPointF& at) const;
    [[nodiscard]] std::vector<KeyPlace> keysIn(const QRectF& box) const;
    void dragKeys(const QPointF& to, bool stretches);
    /// Where the name of a lane is read: in the first gap between its keys that is wide enough.
    [[nodiscard]] double labelLeft(const Track& track, const QString& label) const;
    void paintLane(QPainter& painter, const Track& track, double top) const;

    Document& m_document;
    Player& m_player;
    const TimelineRuler& m_ruler;
    KeySelection& m_selection; ///< its tracks have a lane each
    bool m_marksShown = false;
    Drag m_drag = Drag::None;
    QPointF m_press;
    QPointF m_at;
    bool m_hasMoved = false;
    Gesture m_gesture;
    std::vector<Track> m_base; ///< before the gesture
    std::vector<KeyPlace> m_dragged; ///< in it; of a box: those that were selected before
};

} // namespace fumage::ui
