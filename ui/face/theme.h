#pragma once

#include <QPalette>
#include <QString>

class QApplication;

namespace fumage::ui {

enum class Theme {
    System, ///< light or dark as the desktop is
    Dark,
    Light,
};

/// Whether a palette is light on dark. That of the application tells of the desktop until applyTheme() puts the program's own in its place.
[[nodiscard]] bool isDark(const QPalette& palette);

/// Colours and style sheet for the whole application; open windows follow at once.
/// @param desktopIsDark what Theme::System means
void applyTheme(QApplication& application, Theme theme, bool desktopIsDark);

} // namespace fumage::ui
