#pragma once

#include "ui/document/document.h"

#include "core/rendering/camera.h"

#include <QColor>
#include <QPointF>

#include <optional>
#include <vector>

namespace fumage::ui {

/// The handles in the viewport that stand for parameters and can be dragged.
enum class GizmoId {
    EmitterPosition,
    EmitterNormal,
    Wind,
    VortexAxis,
    Rings, ///< rim of the ring that is one spacing away: its height is the spacing, its distance from the axis the
           ///< radius
    Light,
    Obstacle, ///< in the air
    ObstacleSize, ///< a corner of the box, or a point of the ball
    AirPlace, ///< lower corner of a box that does not fit itself to the smoke
    AirSize, ///< the upper corner across from it
};

struct Gizmo {
    GizmoId id;
    glm::vec3 from; ///< m
    glm::vec3 to; ///< the handle
    QColor colour;
    QString label;
};

/// The gizmos of an effect, of the same size on the screen from any distance, but for the ring; vortex and rings only
/// where there are such.
[[nodiscard]] std::vector<Gizmo> gizmosOf(const Effect& effect, const View& view);

/// @return the gizmo whose handle lies under the mouse, the nearest to it
[[nodiscard]] std::optional<GizmoId> gizmoAt(const Effect& effect, const View& view, QPointF mouse);

/// What a drag of a gizmo to a place means.
/// @param effect as it was when the drag began
/// @param snap   angles to 15 degrees, positions to 0.1 m
[[nodiscard]] std::vector<Assignment> dragGizmo(
    GizmoId id, const Effect& effect, const View& view, QPointF mouse, bool snap);

/// Where the mouse meets the plane through a place that faces the camera.
/// @param snap to 0.1 m
[[nodiscard]] glm::vec3 placeFacing(const View& view, const glm::vec3& before, QPointF mouse, bool snap);

/// Whether a handle is one of the box of the air.
[[nodiscard]] bool isOfAir(GizmoId id);

} // namespace fumage::ui
