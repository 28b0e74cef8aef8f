#pragma once

#include "ui/preview/picture.h"

#include <QElapsedTimer>
#include <QFrame>
#include <QTimer>

class QLabel;
class QToolButton;

namespace fumage::ui {

/// A line over the viewport that says what a picture waits for, how far that is and how long it will take, with a
/// button that stops it. Comes only where something takes long.
class WorkLine : public QFrame {
    Q_OBJECT

public:
    explicit WorkLine(QWidget* parent);

    /// @param share that is done, below 0 where it is not known; Phase::Idle: nothing is waited for
    void follow(Phase phase, double share);
    /// It was stopped, and can go on.
    void showStopped(bool stopped);
    [[nodiscard]] QString text() const;

    /// What it says. @param secondsLeft below 0: not known
    [[nodiscard]] static QString textFor(Phase phase, double share, double secondsLeft);

signals:
    void stopped();
    void resumed();
    /// It has come or gone.
    void shownChanged();

private:
    void press();
    void appear();
    void say();
    void settle();

    QLabel* m_label;
    QToolButton* m_button;
    QTimer m_delay; ///< until it comes
    QTimer m_linger; ///< until it goes: phases follow one another
    QElapsedTimer m_sincePhase;
    Phase m_phase = Phase::Idle;
    double m_share = -1.0;
    double m_firstShare = 0.0; ///< with which the phase began
    bool m_stopped = false;
};

} // namespace fumage::ui
