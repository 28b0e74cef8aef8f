#pragma once

#include <QString>

class QWidget;

namespace fumage::ui {

class Settings;
struct ManualFolders;

/// The reference of all parameters as rich text, made from the parameter table; each has its key as an anchor.
[[nodiscard]] QString parameterReference();

/// All shortcuts as rich text, made from the table of actions.
[[nodiscard]] QString shortcutSheet();

/// The same as plain text: a line each, keys and what they do with a tabulator between.
[[nodiscard]] QString shortcutLines();

/// What in the reference belongs to a widget: the key of the parameter whose row, label or field it is part of, or the
/// name of the group; empty: nothing.
[[nodiscard]] QString referenceAnchorAt(const QWidget* widget);
/// The same of what the mouse is over, or else of what has the keyboard.
[[nodiscard]] QString referenceAnchorAtHand();

/// @param anchor where to begin: the key of a parameter or the name of a group; empty: at the top
/// @param note said above it; empty: nothing
void showReference(QWidget* parent, const QString& anchor = {}, const QString& note = {});
/// Shows the manual in a window that stays open beside the work, or brings that to the front; where there is none, the
/// reference of parameters, which says why.
/// @param settings remember size and place of the window
/// @param folders  of the manual
/// @param anchor   where to begin, as above
void showManual(QWidget* parent, Settings& settings, const ManualFolders& folders, const QString& anchor = {});
void showShortcuts(QWidget* parent);
void showAbout(QWidget* parent);

} // namespace fumage::ui
