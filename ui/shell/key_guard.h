#pragma once

#include <QObject>

namespace fumage::ui {

/// Leaves plain keys to the widget that has the focus where it has a use for them, before they act as shortcuts of the window:
/// Space presses a button, arrows move a slider, letters search a list.
class KeyGuard : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace fumage::ui
