#pragma once

#include <QDeadlineTimer>
#include <QHash>
#include <QObject>

class QRect;
class QWidget;

namespace fumage::ui {

/// Keeps every window and dialog of the application on its screen when it opens, frame and title bar counted. Where
/// the hand puts it later is up to the hand.
class WindowKeeper : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void settle(QWidget& window);

    QHash<const QObject*, QDeadlineTimer> m_fresh; ///< have been opened, and until when their places are not final
};

/// Makes a window no larger than its screen, and moves it onto that, with its frame; what is maximised stays as it is.
void keepOnScreen(QWidget& window);

/// Puts a dialog right of a window, as far as the screen goes: what is framed in the middle stays in sight.
void placeBeside(const QWidget& window, QWidget& dialog);

} // namespace fumage::ui
