#include "ui/viewport/navigation.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace fumage::ui {

namespace {

constexpr float kHalfTurn = 180.0F;
constexpr float kFullTurn = 360.0F;
constexpr float kSteepest = 89.0F;
constexpr double kZoomOfNotch = 1.12;

float wrapped(float degrees)
{
    return std::remainder(degrees, kFullTurn);
}

glm::vec3 turned(const glm::vec3& view, float yawDegrees, float pitchDegrees)
{
    const float yaw = std::atan2(view.x, -view.z) + glm::radians(yawDegrees);
    const float steepest = glm::radians(kSteepest);
    const float pitch =
        std::clamp(std::asin(std::clamp(view.y, -1.0F, 1.0F)) + glm::radians(pitchDegrees), -steepest, steepest);
    return {std::sin(yaw) * std::cos(pitch), std::sin(pitch), -std::cos(yaw) * std::cos(pitch)};
}

std::optional<CameraMove> middleInBlender(Qt::KeyboardModifiers modifiers)
{
    if (modifiers.testFlag(Qt::ShiftModifier)) {
        return CameraMove::Pan;
    }
    return modifiers.testFlag(Qt::ControlModifier) ? CameraMove::Zoom : CameraMove::Orbit;
}

} // namespace

std::optional<CameraMove> cameraMoveFor(NavigationStyle style, Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
    const bool alt = modifiers.testFlag(Qt::AltModifier);
    if (button == Qt::LeftButton) {
        return modifiers.testFlag(Qt::ShiftModifier) && !alt ? CameraMove::Pan : CameraMove::Orbit;
    }
    const bool middle = button == Qt::MiddleButton;
    if (!middle && button != Qt::RightButton) {
        return std::nullopt;
    }
    switch (style) {
    case NavigationStyle::Blender: return middle ? middleInBlender(modifiers) : std::nullopt;
    case NavigationStyle::Maya:
        if (!alt) {
            return std::nullopt;
        }
        break;
    case NavigationStyle::Unity:
        if (!middle && !alt) {
            return CameraMove::Look;
        }
        break;
    }
    return middle ? CameraMove::Pan : CameraMove::Zoom;
}

Camera orbited(const Camera& camera, QPointF pixels, const View& view)
{
    const float degreesAPixel = kHalfTurn / static_cast<float>(std::max(1, view.height));
    const float across = static_cast<float>(pixels.x()) * degreesAPixel;
    const float down = static_cast<float>(pixels.y()) * degreesAPixel;
    Camera out = camera;
    if (camera.mode == CameraMode::Fixed) {
        out.view = turned(glm::normalize(camera.view), across, -down);
        return out;
    }
    out.yaw = wrapped(camera.yaw - across);
    out.pitch = std::clamp(camera.pitch + down, -kSteepest, kSteepest);
    return out;
}

Camera lookedAround(const Camera& camera, QPointF pixels, const View& view)
{
    Camera standing = camera;
    standing.mode = CameraMode::Fixed;
    standing.view = view.forward;
    Camera out = orbited(camera, pixels, view);
    out.target = view.eye + orbited(standing, pixels, view).view * camera.distance;
    return out;
}

Camera panned(const Camera& camera, QPointF pixels, const View& view)
{
    const float metresAPixel = camera.distance / view.focal;
    const glm::vec3 way =
        (view.up * static_cast<float>(pixels.y()) - view.right * static_cast<float>(pixels.x())) * metresAPixel;
    Camera out = camera;
    (camera.mode == CameraMode::Fixed ? out.position : out.target) += way;
    return out;
}

Camera zoomed(const Camera& camera, double notches, const View& view)
{
    const auto factor = static_cast<float>(std::pow(kZoomOfNotch, -notches));
    Camera out = camera;
    if (camera.mode == CameraMode::Fixed) {
        out.position += view.forward * (camera.distance * (1.0F - factor));
        return out;
    }
    out.distance = camera.distance * factor;
    return out;
}

Camera lookingFrom(const Camera& camera, float yaw, float pitch)
{
    Camera out = camera;
    out.mode = CameraMode::Orbit;
    out.yaw = yaw;
    out.pitch = pitch;
    return out;
}

Camera framing(const Camera& camera, const glm::vec3& low, const glm::vec3& high)
{
    constexpr float kMargin = 1.15F;
    constexpr float kSmallestRadius = 0.05F;
    const float radius = std::max(kSmallestRadius, 0.5F * glm::length(high - low));
    Camera out = camera;
    out.mode = CameraMode::Orbit;
    out.target = 0.5F * (low + high);
    // A sphere fills the field of view where the distance is r / sin(half angle).
    out.distance = kMargin * radius / std::sin(std::atan(0.5F * kSensorMillimetres / camera.focalLength));
    return out;
}

glm::vec3 rayThrough(const View& view, QPointF pixel)
{
    const float x = static_cast<float>(pixel.x()) - 0.5F * static_cast<float>(view.width);
    const float y = 0.5F * static_cast<float>(view.height) - static_cast<float>(pixel.y());
    return glm::normalize(view.forward * view.focal + view.right * x + view.up * y);
}

} // namespace fumage::ui
