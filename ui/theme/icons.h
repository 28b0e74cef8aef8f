#pragma once

#include <QIcon>

class QToolButton;
class QWidget;

namespace fumage::ui {

/// An icon of the project's family in the colour of the present theme, sharp at any size; follows when the theme
/// changes.
/// @param name of a file in resources/icons, without ending
[[nodiscard]] QIcon themedIcon(const QString& name);

/// A flat button that shows an icon; its tip is also its accessible name.
/// @param name objectName
[[nodiscard]] QToolButton* makeIconButton(
    QWidget* parent, const QString& name, const QString& icon, const QString& tip);

} // namespace fumage::ui
