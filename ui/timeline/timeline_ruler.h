#pragma once

#include "ui/timeline/player.h"

#include <QList>
#include <QWidget>

namespace fumage::ui {

/// The ruler: a cursor to drag, the range that is played with its ends to drag, and the frames whose pictures are kept.
class TimelineRuler : public QWidget {
    Q_OBJECT

public:
    TimelineRuler(Player& player, QWidget* parent);

    void setCached(const QList<int>& frames);
    /// Shows how much of the air is baked. @param share 0 to 1; 1 shows nothing
    void setBaking(double share);
    [[nodiscard]] double baking() const { return m_baking; }
    [[nodiscard]] double xOf(double frame) const;
    /// Frames from one number to the next: 1, 2, 5, 10, 20, 50 ...
    [[nodiscard]] int tickStep() const;

    QSize sizeHint() const override { return {400, 40}; }

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    enum class Grip {
        None,
        Cursor,
        First,
        Last,
    };
    [[nodiscard]] int frameAt(double x) const;
    void paintTicks(QPainter& painter) const;
    void paintBaking(QPainter& painter) const;

    Player& m_player;
    QList<int> m_cached;
    double m_baking = 1.0;
    Grip m_grip = Grip::None;
    bool m_wasPlaying = false;
    struct {
        int frame = 0;
        int first = 0;
        int last = 0;
    } m_before; ///< the drag
};

} // namespace fumage::ui
