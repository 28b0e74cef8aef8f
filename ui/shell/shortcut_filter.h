#pragma once

#include <QObject>

namespace fumage::ui {

/// Leaves plain keys to the widget that has the focus where it has a use for them, before they act as shortcuts of the
/// window: Space presses a button, arrows move a slider, letters search a list. Where the mouse has chosen in a list or
/// pressed a button, the keyboard goes back to the picture, so that Space plays. Shortcuts of digits and letters are
/// found by the place of their keys where the layout has none.
class ShortcutFilter : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace fumage::ui
