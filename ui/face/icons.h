#pragma once

#include <QIcon>

namespace fumage::ui {

/// An icon of the project's family in the colour of the present theme, sharp at any size; follows when the theme changes.
/// @param name of a file in resources/icons, without ending
[[nodiscard]] QIcon themedIcon(const QString& name);

} // namespace fumage::ui
