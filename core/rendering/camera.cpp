#include "core/rendering/camera.h"

#include "core/base/math.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace fumage {

namespace {

/// Fills the axes from a viewing direction, level with the horizon; straight up or down takes -z as the top of the
/// picture.
void aim(View& view, const glm::vec3& direction)
{
    view.forward = glm::normalize(direction);
    const bool vertical = std::abs(view.forward.y) > 0.9999F;
    const glm::vec3 sky = vertical ? glm::vec3(0.0F, 0.0F, -1.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
    view.right = glm::normalize(glm::cross(view.forward, sky));
    view.up = glm::cross(view.right, view.forward);
}

} // namespace

View makeView(const Camera& camera, float seconds, int width, int height)
{
    View view;
    view.width = width;
    view.height = height;
    view.focal = camera.focalLength / kSensorMillimetres * static_cast<float>(std::min(width, height));
    if (camera.mode == CameraMode::Fixed) {
        view.eye = camera.position;
        aim(view, camera.view);
        return view;
    }
    // A turntable of hours is still an angle that sine and cosine know.
    constexpr float kFullTurn = 360.0F;
    const float yaw = radians(std::fmod(camera.yaw + camera.turntable * seconds, kFullTurn));
    const float pitch = radians(camera.pitch);
    const glm::vec3 outward(
        portableSin(yaw) * portableCos(pitch), portableSin(pitch), portableCos(yaw) * portableCos(pitch));
    view.eye = camera.target + outward * camera.distance;
    aim(view, -outward);
    return view;
}

Projected project(const View& view, const glm::vec3& point)
{
    const glm::vec3 way = point - view.eye;
    Projected out;
    out.depth = glm::dot(way, view.forward);
    if (out.depth > 0.0F) {
        out.x = 0.5F * static_cast<float>(view.width) + view.focal * glm::dot(way, view.right) / out.depth;
        out.y = 0.5F * static_cast<float>(view.height) - view.focal * glm::dot(way, view.up) / out.depth;
    }
    return out;
}

} // namespace fumage
