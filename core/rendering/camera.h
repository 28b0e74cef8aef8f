#pragma once

#include "core/effect/effect.h"

#include <glm/vec3.hpp>

namespace fumage {

/// Edge of the square that a picture's shorter side sees: focal lengths are those of full-frame photography.
inline constexpr float kSensorMillimetres = 36.0F;

/// Nearer than this to the camera nothing is drawn, m.
inline constexpr float kNear = 0.02F;

/// A camera at one moment, ready to project: a pinhole with square pixels, image origin top-left, y down.
struct View {
    glm::vec3 eye{0.0F};
    glm::vec3 right{1.0F, 0.0F, 0.0F};
    glm::vec3 up{0.0F, 1.0F, 0.0F};
    glm::vec3 forward{0.0F, 0.0F, -1.0F};
    float focal = 1.0F; ///< focal length in pixels
    int width = 1;
    int height = 1;
};

/// Time of a frame since frame 0, as cameras and framings take it.
[[nodiscard]] inline float secondsOf(const Timeline& timeline, int frame)
{
    return static_cast<float>(frame) / static_cast<float>(timeline.frameRate);
}

/// @param seconds time since frame 0, for the turntable
/// @param width,height picture in pixels; the shorter side sees the whole sensor, so that a picture of any shape shows
/// at least what a square one does
[[nodiscard]] View makeView(const Camera& camera, float seconds, int width, int height);

struct Projected {
    float x = 0.0F; ///< pixels from the left
    float y = 0.0F; ///< pixels from the top
    float depth = 0.0F; ///< m along the view; not in front of the camera where 0 or less
};

/// @param point in metres
/// @return where it is seen; x and y mean nothing where the depth is 0 or less
[[nodiscard]] Projected project(const View& view, const glm::vec3& point);

} // namespace fumage
