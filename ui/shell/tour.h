#pragma once

#include <QFrame>
#include <QPointer>

#include <functional>
#include <vector>

class QLabel;
class QMainWindow;
class QPushButton;
class QShortcut;

namespace fumage::ui {

/// A step of a tour: what is said, and the control that it is said of.
struct TourStep {
    QString text;
    std::function<QWidget*()> find; ///< null: it is not there
};

/// A tour of a window: a bubble beside one control after another. Nothing waits for it: all that it speaks of can be
/// tried meanwhile. Steps whose controls are not to be seen, in a panel that is put away, say, are left out.
/// Arrows go on and back, Escape ends it, and so does going on from the last step; then it deletes itself.
class Tour : public QFrame {
    Q_OBJECT

public:
    /// Begins a tour in place of the one that is there. @return null: none of its controls is to be seen
    static Tour* start(QMainWindow& window, std::vector<TourStep> steps);

    /// The step that is shown, an index.
    [[nodiscard]] int step() const { return m_step; }
    /// What the step speaks of.
    [[nodiscard]] QWidget* target() const { return m_target; }
    void next();
    void back();
    void end();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    Tour(QMainWindow& window, std::vector<TourStep> steps);
    [[nodiscard]] QWidget* shownTarget(int step) const;
    /// The next step in a direction whose control is to be seen; -1: there is none.
    [[nodiscard]] int stepFrom(int step, int direction) const;
    void showStep(int step);
    void place();

    QMainWindow& m_window;
    const std::vector<TourStep> m_steps;
    int m_step = -1;
    QPointer<QWidget> m_target;
    QLabel* m_text;
    QPushButton* m_back;
    QPushButton* m_next;
    QPushButton* m_done;
    QShortcut* m_escape;
};

} // namespace fumage::ui
