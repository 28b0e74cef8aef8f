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

/// Whether a palette is light on dark. That of the application tells of the desktop until applyTheme() puts the
/// program's own in its place.
[[nodiscard]] bool isDark(const QPalette& palette);

/// The colours of a theme, by what they are for.
struct ThemeColours {
    QRgb window;
    QRgb base; ///< behind fields and lists
    QRgb raised; ///< buttons, headings
    QRgb edge; ///< of what is seen by its contents
    QRgb control; ///< edge of what is seen by its edge alone: boxes to check
    QRgb text;
    QRgb quiet; ///< text that stands back
    QRgb accent;
    QRgb onAccent;
    QRgb mark; ///< what differs from the preset
    QRgb good; ///< what has been looked at and is right
};

[[nodiscard]] const ThemeColours& themeColours(bool dark);

/// Colours and style sheet for the whole application; open windows follow at once.
/// @param desktopIsDark what Theme::System means
void applyTheme(QApplication& application, Theme theme, bool desktopIsDark);

} // namespace fumage::ui
