#pragma once

#include <QString>

namespace fumage::ui {

/// The editor from start to end. @return exit code
int runEditor(int argc, char** argv);

/// What the desktop's entry of the program is called, by which Wayland knows its windows: that of the packages, or that
/// of the Flatpak, whose files are called after its id.
/// @return without .desktop
[[nodiscard]] QString desktopFileName();

} // namespace fumage::ui
