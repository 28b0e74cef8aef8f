#pragma once

#include <QPainterPath>
#include <QStringView>

#include <optional>

namespace fumage::ui {

/// The outline that an SVG's path data describe: M L H V C S A Z, absolute and relative.
/// @return nothing where they are no path data, or use another command
[[nodiscard]] std::optional<QPainterPath> readSvgPath(QStringView data);

} // namespace fumage::ui
