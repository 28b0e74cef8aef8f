#pragma once

#include <QString>

namespace fumage::ui {

/// Where all that belongs to the user is kept when the program is carried about: the folder fumage-data beside the
/// program, if there is one that takes files: on a medium or in a folder where nothing can be written, work would else
/// be lost.
/// @return an absolute folder, the same for as long as the program runs; empty: it is kept where the system has its
/// users keep such things
[[nodiscard]] QString portableFolder();

/// Has settings and the user's presets kept in the portable folder, if there is one. Once the application is there,
/// before anything is read.
void usePortableFolder();

} // namespace fumage::ui
