#pragma once

#include "core/export/plan.h"
#include "ui/timeline/player.h"

#include <QWidget>

class QLabel;
class QSpinBox;

namespace fumage::ui {

/// Which frames are exported: a range, or of a single picture the frame on the screen, until another is typed.
class RangeRow : public QWidget {
    Q_OBJECT

public:
    RangeRow(Player& player, QWidget* parent);

    /// Shows what a kind asks for.
    void follow(ExportKind kind);
    /// Whether a kind has frames.
    [[nodiscard]] static bool isAskedOf(ExportKind kind) { return kind != ExportKind::NoiseTexture; }
    /// @return of a single picture: its frame
    [[nodiscard]] FrameRange frames(ExportKind kind) const;
    void setFrames(const FrameRange& frames);
    /// Those that the player plays, and the one that it shows.
    void takePlayed();

signals:
    void changed();

private:
    void takeShown();
    void sayWhichIsShown();

    Player& m_player;
    QSpinBox* m_frame;
    QLabel* m_shown; ///< says that the frame is the one on the screen
    QWidget* m_range;
    QSpinBox* m_first;
    QSpinBox* m_last;
    QSpinBox* m_step;
};

} // namespace fumage::ui
