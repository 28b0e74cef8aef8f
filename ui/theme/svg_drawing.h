#pragma once

#include <QByteArray>

class QPainter;
class QRectF;

namespace fumage::ui {

/// Draws what the program's own icons are made of: lines, circles, ellipses, boxes and paths with plain colours or
/// gradients over the box of a shape; no text, no CSS, no transforms, no references to other files. Qt's own module for
/// SVG would be one library more that whoever packs the program has to build.
/// @param into the view box is fitted into its middle
/// @return whether all that stands in the SVG is known here; if not, what is known is drawn
[[nodiscard]] bool drawSvg(QPainter& painter, const QByteArray& svg, const QRectF& into);

} // namespace fumage::ui
