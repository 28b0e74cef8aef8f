#pragma once

#include <QString>

class QWidget;

namespace fumage::ui {

/// The reference of all parameters as rich text, made from the parameter table; each has its key as an anchor.
[[nodiscard]] QString parameterReference();

/// All shortcuts as rich text, made from the table of actions.
[[nodiscard]] QString shortcutSheet();

void showReference(QWidget* parent);
void showShortcuts(QWidget* parent);
void showAbout(QWidget* parent);

} // namespace fumage::ui
