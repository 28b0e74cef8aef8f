#pragma once

#include "ui/document/document.h"

#include "core/rendering/camera.h"

#include <QPointF>

#include <optional>

namespace fumage::ui {

/// Whose mouse habits the viewport follows.
enum class NavigationStyle {
    Blender, ///< middle: orbit; with Shift: pan; with Ctrl: zoom
    Maya, ///< with Alt, left: orbit; middle: pan; right: zoom
    Unity, ///< Alt with left: orbit; middle: pan; right: look around; Alt with right: zoom
};

enum class CameraMove {
    Orbit,
    Pan,
    Zoom,
    Look, ///< the eye stays where it is
};

/// What a button means; the bare left button orbits in every style, for hands with one button.
[[nodiscard]] std::optional<CameraMove> cameraMoveFor(
    NavigationStyle style, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);

// Cameras moved by the mouse. A fixed camera turns, slides and walks instead.

/// @param pixels way of the mouse; the whole height of the view is half a turn
[[nodiscard]] Camera orbited(const Camera& camera, QPointF pixels, const View& view);
/// The view turns about the eye.
[[nodiscard]] Camera lookedAround(const Camera& camera, QPointF pixels, const View& view);
/// The point under the mouse, at the distance of the target, stays under it.
[[nodiscard]] Camera panned(const Camera& camera, QPointF pixels, const View& view);
/// @param notches of the wheel; more than 0 goes nearer
[[nodiscard]] Camera zoomed(const Camera& camera, double notches, const View& view);
[[nodiscard]] Camera lookingFrom(const Camera& camera, float yaw, float pitch);
/// The whole box in sight, from where the camera looks now.
[[nodiscard]] Camera framing(const Camera& camera, const glm::vec3& low, const glm::vec3& high);

/// The way from the eye through a pixel, of unit length.
[[nodiscard]] glm::vec3 rayThrough(const View& view, QPointF pixel);

} // namespace fumage::ui
