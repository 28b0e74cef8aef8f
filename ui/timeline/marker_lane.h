#pragma once

#include "ui/document/marker_edits.h"
#include "ui/timeline/player.h"

#include <QWidget>

#include <optional>
#include <vector>

class QLineEdit;

namespace fumage::ui {

class TimelineRuler;

/// The markers of the timeline as flags with their names, over the ruler and in line with it. A click goes to a marker,
/// a drag moves it by frames, a double-click names it, a menu removes it. It takes no room where there is none.
class MarkerLane : public QWidget {
    Q_OBJECT

public:
    /// @param ruler that says where a frame lies
    MarkerLane(Document& document, Player& player, const TimelineRuler& ruler, QWidget* parent);
    ~MarkerLane() override;

    /// Where the flag of a marker is painted: from its time to the next, or to the end of its name.
    /// @param marker below their number
    [[nodiscard]] QRectF flagOf(std::size_t marker) const;
    /// The marker whose flag is somewhere; of several at one time the last.
    [[nodiscard]] std::optional<std::size_t> markerUnder(const QPointF& at) const;
    /// Lets the hand write another name into the flag. Return takes it over, Escape does not.
    /// @param marker below their number
    void rename(std::size_t marker);

    QSize sizeHint() const override { return {400, kHeight}; }

    static constexpr int kHeight = 18; ///< pixels

signals:
    /// It has come, or gone.
    void heightChanged();

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void sync();
    [[nodiscard]] double frameRate() const;
    /// A marker of the gesture, which its base has, moved with the hand.
    void drag(const QPointF& to);
    /// Ends the writing of a name.
    void endRename(bool takesOver);

    Document& m_document;
    Player& m_player;
    const TimelineRuler& m_ruler;
    std::vector<Marker> m_markers; ///< that are shown
    std::optional<std::size_t> m_dragged; ///< of m_base
    std::vector<Marker> m_base; ///< before the gesture
    Gesture m_gesture;
    QPointF m_press;
    bool m_hasMoved = false;
    QLineEdit* m_editor = nullptr; ///< while a name is written
    std::size_t m_renamed = 0;
};

} // namespace fumage::ui
