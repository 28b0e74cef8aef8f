#pragma once

#include "ui/viewport/gizmos.h"

#include <QRectF>

#include <optional>
#include <vector>

class QPainter;

namespace fumage::ui {

/// Where a label finds room: at its place, or under what stands there already.
[[nodiscard]] QRectF freePlace(QRectF wanted, const std::vector<QRectF>& taken);

/// Draws the handles with their labels, which do not lie on one another. @param hot under the mouse
void paintGizmos(QPainter& painter, const Effect& effect, const View& view, std::optional<GizmoId> hot);

} // namespace fumage::ui
