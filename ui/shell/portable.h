#pragma once

#include <QString>

namespace fumage::ui {

/// Where all that belongs to the user is kept when the program is carried about: the folder fumage-data beside the
/// program, if there is one.
/// @return an absolute folder; empty: it is kept where the system has its users keep such things
[[nodiscard]] QString portableFolder();

/// Has settings and the user's presets kept in the portable folder, if there is one. Once the application is there,
/// before anything is read.
void usePortableFolder();

} // namespace fumage::ui
