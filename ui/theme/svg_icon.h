#pragma once

#include <QIconEngine>

namespace fumage::ui {

/// An icon engine that draws an SVG file, sharp at any size; what says currentColor in it has the colour of the text of
/// buttons. QIcon deletes it.
[[nodiscard]] QIconEngine* makeSvgIconEngine(const QString& file);

} // namespace fumage::ui
