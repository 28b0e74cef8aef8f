#pragma once

#include "core/lighting/appearance.h"
#include "core/rendering/camera.h"
#include "core/rendering/image.h"

#include <limits>
#include <vector>

namespace fumage {

/// Where in a picture there is smoke, in pixels: from the outer edge of the first to that of the last.
struct PictureReach {
    int left = 0, right = 0, top = 0, bottom = 0; ///< right <= left: nowhere

    [[nodiscard]] bool isEmpty() const { return right <= left; }
    friend bool operator==(const PictureReach&, const PictureReach&) = default;
};

/// @param alpha what is less than this is not seen
[[nodiscard]] PictureReach reachOf(const Image& image, float alpha);

/// How far from the eye particles lie along its way, m.
struct DepthRange {
    float nearest, farthest;
    float middle; ///< mean, each by what it covers: one that has flown off does not count
};

/// Gathers how far particles lie from the eye.
class Depths {
public:
    /// @param depth m
    /// @param cover of the picture, more than 0, in any unit that is the same for all
    void add(float depth, float cover);

    [[nodiscard]] bool isEmpty() const { return !(m_covered > 0.0); }
    /// Of at least one particle.
    [[nodiscard]] DepthRange range() const { return {m_nearest, m_farthest, static_cast<float>(m_sum / m_covered)}; }

private:
    float m_nearest = std::numeric_limits<float>::infinity();
    float m_farthest = -std::numeric_limits<float>::infinity();
    double m_covered = 0.0;
    double m_sum = 0.0; ///< of depths times covers
};

/// Finds where a camera must stand so that the smoke of many moments is within its picture, looking the way it does.
///
/// A point p is within when |(p - e).r| <= t (p - e).f, e the eye, r and f the camera's right and forward, t half the
/// picture's width over the focal length; likewise for up. Of all points only the largest p.r - t p.f and its like for
/// the three other sides matter, which is all that is kept of a moment.
class Framing {
public:
    /// @param width,height of the picture, pixels
    Framing(const Camera& camera, int width, int height);

    /// Takes the discs of all particles that are not quite clear.
    /// @param appearance of the same frame, with any axes
    void addParticles(const Particles& particles, const Appearance& appearance, float seconds);

    /// Takes what a picture of the smoke shows, through a camera that looks the same way from anywhere. Where smoke
    /// touches the picture's border more of it is taken to be outside.
    /// @param reach in pixels of the view
    /// @param depths nearest more than 0
    void addPicture(const View& view, const PictureReach& reach, const DepthRange& depths, float seconds);

    [[nodiscard]] bool isEmpty() const { return m_moments.empty(); }

    /// The camera that sees all that was added, with a margin: nearest of all where the camera does not turn, near it
    /// on a turntable. A camera that does not turn has its target in the middle of the smoke's depth, so that the hand
    /// orbits around the smoke.
    [[nodiscard]] Camera camera() const;

    /// What lies between the margins of the pictures that camera() sees, outwards to whole pixels.
    [[nodiscard]] PictureReach inner() const;

    /// How far from its target, m, a camera would have to be to see all that was added.
    [[nodiscard]] float distanceFrom(const glm::vec3& target) const { return demandAt(target).distance; }

private:
    /// What one moment asks for, in the axes of its camera.
    struct Moment {
        glm::vec3 right, up, forward;
        float toRight, toLeft, upwards, downwards; ///< largest p.r - t p.f, -p.r - t p.f, p.u - t p.f, -p.u - t p.f
        DepthRange along; ///< p.f
    };
    /// What asks a camera to stand farthest from its target.
    struct Demand {
        float distance;
        glm::vec3 way; ///< in which the target moves to lessen it
    };
    [[nodiscard]] Demand demandAt(const glm::vec3& target) const;
    [[nodiscard]] Camera still() const;
    [[nodiscard]] Camera turning() const;

    Camera m_camera;
    int m_width;
    int m_height;
    float m_tangentX; ///< of half the angle that is seen, less the margin
    float m_tangentY;
    std::vector<Moment> m_moments;
};

} // namespace fumage
