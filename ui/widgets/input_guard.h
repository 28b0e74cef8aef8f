#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>

class QMouseEvent;

namespace fumage::ui {

class DragEnd;

/// Stands before all widgets of the application, so that none can forget what holds for the hand everywhere:
/// - only the left button changes anything; the right one opens menus;
/// - a wheel that passes over a field belongs to what scrolls: a list and the head of a tab never take it, a number or
///   a slider only with the focus;
/// - a drag ends with its button: also where the release never came, because a dialog or another window took it;
/// - Escape takes a drag back, and so do undo and redo, which do nothing else then: takeDragBack(). What else changes
///   the document ends it first: endDrag().
class InputGuard : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// For a widget that knows what to do with each button.
    static void leaveAllButtons(QWidget& widget);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// @return whether the widget must not see the event
    bool press(QWidget& widget, const QMouseEvent& event);
    bool move(const QWidget& widget, const QMouseEvent& event);
    bool release(const QWidget& widget, const QMouseEvent& event);
    bool isEndOfDrag(const QObject& watched, const QEvent& event) const;
    /// The held widget gets the release that did not come.
    void letGo();
    /// @return whether anybody had something to take back
    bool takeBack();
    void end(DragEnd& end);

    QPointer<QWidget> m_held; ///< has got a press and no release yet
    Qt::MouseButton m_button = Qt::NoButton; ///< that holds it
    bool m_spent = false; ///< the drag is over, though the button is still down
};

} // namespace fumage::ui
