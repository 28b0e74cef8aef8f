#pragma once

#include "ui/document/document.h"
#include "ui/timeline/player.h"

#include <QWidget>

#include <array>

class QCheckBox;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QMenu;
class QSpinBox;
class QToolButton;

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

/// Play, step, scrub, range, repeat, seamless loop, speed and frame rate.
class TimelineBar : public QWidget {
    Q_OBJECT

public:
    TimelineBar(Document& document, Player& player, QWidget* parent = nullptr);

    [[nodiscard]] TimelineRuler& ruler() const { return *m_ruler; }

    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void giveWay();
    /// What goes on a narrow screen, the first of them first.
    [[nodiscard]] std::array<QWidget*, 4> dispensable() const;
    void addButtons(QHBoxLayout& controls);
    void addFrameAndTime(QHBoxLayout& controls);
    void addLoop(QHBoxLayout& controls);
    void addSpeedAndRate(QHBoxLayout& controls);
    void addMore(QHBoxLayout& controls);
    /// What the bar has no room for.
    void fillMore(QMenu& menu);
    void connectPlayer();
    void followDocument();
    void sync();
    void showTime();

    Document& m_document;
    Player& m_player;
    QHBoxLayout* m_controls;
    TimelineRuler* m_ruler;
    QToolButton* m_play;
    QToolButton* m_repeat;
    QToolButton* m_more; ///< there while something is hidden
    QCheckBox* m_loop; ///< a parameter of the document
    QSpinBox* m_frame;
    QLabel* m_time;
    QComboBox* m_speed;
    QSpinBox* m_rate;
};

} // namespace fumage::ui
