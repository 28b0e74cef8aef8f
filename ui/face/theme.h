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

/// Colours and style sheet for the whole application; open windows follow at once.
void applyTheme(QApplication& application, Theme theme);

/// Whether the desktop was light or dark before applyTheme() was first called.
[[nodiscard]] bool desktopIsDark();

} // namespace fumage::ui
