#include "core/rendering/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace fumage {

namespace {

/// Of each half of the picture that stays free.
constexpr float kMargin = 0.04F;
/// Particles fainter than this are not seen, however many there are.
constexpr float kFaintest = 1e-4F;
constexpr float kNearest = 0.05F; ///< m before the eye
constexpr float kInfinity = std::numeric_limits<float>::infinity();

bool rowShows(const Image& image, int y, float alpha)
{
    const float* row = image.row(y);
    for (int x = 0; x < image.width; ++x) {
        if (row[4 * x + 3] >= alpha) {
            return true;
        }
    }
    return false;
}

bool columnShows(const Image& image, int x, int top, int bottom, float alpha)
{
    for (int y = top; y < bottom; ++y) {
        if (image.row(y)[4 * x + 3] >= alpha) {
            return true;
        }
    }
    return false;
}

} // namespace

PictureReach reachOf(const Image& image, float alpha)
{
    PictureReach reach{.left = 0, .right = image.width, .top = 0, .bottom = image.height};
    while (reach.top < reach.bottom && !rowShows(image, reach.top, alpha)) {
        ++reach.top;
    }
    if (reach.top == reach.bottom) {
        return {};
    }
    while (!rowShows(image, reach.bottom - 1, alpha)) {
        --reach.bottom;
    }
    while (!columnShows(image, reach.left, reach.top, reach.bottom, alpha)) {
        ++reach.left;
    }
    while (!columnShows(image, reach.right - 1, reach.top, reach.bottom, alpha)) {
        --reach.right;
    }
    return reach;
}

void Depths::add(float depth, float cover)
{
    m_nearest = std::min(m_nearest, depth);
    m_farthest = std::max(m_farthest, depth);
    m_covered += static_cast<double>(cover);
    m_sum += static_cast<double>(cover) * static_cast<double>(depth);
}

Framing::Framing(const Camera& camera, int width, int height)
    : m_camera(camera)
    , m_width(width)
    , m_height(height)
{
    const View view = makeView(camera, 0.0F, width, height);
    m_tangentX = (1.0F - kMargin) * 0.5F * static_cast<float>(width) / view.focal;
    m_tangentY = (1.0F - kMargin) * 0.5F * static_cast<float>(height) / view.focal;
}

void Framing::addParticles(const Particles& particles, const Appearance& appearance, float seconds)
{
    const View view = makeView(m_camera, seconds, m_width, m_height);
    Moment moment{view.right, view.up, view.forward, -kInfinity, -kInfinity, -kInfinity, -kInfinity, {}};
    Depths depths;
    for (std::size_t i = 0; i < particles.capacity; ++i) {
        if (!(appearance.alpha[i] > kFaintest && appearance.radius[i] > 0.0F)) {
            continue;
        }
        const glm::vec3 p(particles.x[i], particles.y[i], particles.z[i]);
        const float x = glm::dot(p, view.right);
        const float y = glm::dot(p, view.up);
        const float z = glm::dot(p, view.forward);
        const float radius = appearance.radius[i] * appearance.cover.reach;
        moment.toRight = std::max(moment.toRight, radius + x - m_tangentX * z);
        moment.toLeft = std::max(moment.toLeft, radius - x - m_tangentX * z);
        moment.upwards = std::max(moment.upwards, radius + y - m_tangentY * z);
        moment.downwards = std::max(moment.downwards, radius - y - m_tangentY * z);
        depths.add(z, appearance.alpha[i] * radius * radius);
    }
    if (!depths.isEmpty()) {
        moment.along = depths.range();
        m_moments.push_back(moment);
    }
}

void Framing::addPicture(const View& view, const PictureReach& reach, const DepthRange& depths, float seconds)
{
    if (reach.isEmpty()) {
        return;
    }
    // Tangents of the angles at which the smoke ends; beyond a border that it touches nobody knows.
    constexpr float kBeyond = 1.5F;
    const auto tangent = [&](int outwards, int half2, bool touches) {
        return (touches ? kBeyond : 1.0F) * (static_cast<float>(outwards) - 0.5F * static_cast<float>(half2))
            / view.focal;
    };
    const float toRight = tangent(reach.right, view.width, reach.right == view.width);
    const float toLeft = tangent(view.width - reach.left, view.width, reach.left == 0);
    const float upwards = tangent(view.height - reach.top, view.height, reach.top == 0);
    const float downwards = tangent(reach.bottom, view.height, reach.bottom == view.height);

    const View direction = makeView(m_camera, seconds, m_width, m_height);
    const float x = glm::dot(view.eye, direction.right);
    const float y = glm::dot(view.eye, direction.up);
    const float z = glm::dot(view.eye, direction.forward);
    // The largest along a ray is at one of its ends.
    const auto support = [&](float eye, float slope, float limit) {
        return eye - limit * z + (slope - limit) * (slope > limit ? depths.farthest : depths.nearest);
    };
    m_moments.push_back({direction.right, direction.up, direction.forward, support(x, toRight, m_tangentX),
        support(-x, toLeft, m_tangentX), support(y, upwards, m_tangentY), support(-y, downwards, m_tangentY),
        {z + depths.nearest, z + depths.farthest, z + depths.middle}});
}

Camera Framing::still() const
{
    Moment all = m_moments.front();
    float middle = 0.0F;
    for (const Moment& moment : m_moments) {
        all.toRight = std::max(all.toRight, moment.toRight);
        all.toLeft = std::max(all.toLeft, moment.toLeft);
        all.upwards = std::max(all.upwards, moment.upwards);
        all.downwards = std::max(all.downwards, moment.downwards);
        all.along.nearest = std::min(all.along.nearest, moment.along.nearest);
        middle += moment.along.middle / static_cast<float>(m_moments.size());
    }
    // e.r - t e.f >= toRight and -e.r - t e.f >= toLeft: their sum says how far back, their difference how far aside.
    const float x = 0.5F * (all.toRight - all.toLeft);
    const float y = 0.5F * (all.upwards - all.downwards);
    const float z = std::min({-0.5F * (all.toRight + all.toLeft) / m_tangentX,
        -0.5F * (all.upwards + all.downwards) / m_tangentY, all.along.nearest - kNearest});
    const glm::vec3 eye = x * all.right + y * all.up + z * all.forward;
    Camera out = m_camera;
    out.position = eye;
    out.distance = std::max(kNearest, middle - z);
    out.target = eye + out.distance * all.forward;
    return out;
}

Framing::Demand Framing::demandAt(const glm::vec3& target) const
{
    // With the eye at T - D f each side of each moment asks for D >= (its support - T.(r - t f)) / t, r away from the
    // picture's middle.
    Demand most{kNearest, glm::vec3(0.0F)};
    const auto ask = [&](float support, const glm::vec3& side, float tangent, const glm::vec3& forward) {
        const glm::vec3 normal = side - tangent * forward;
        const float distance = (support - glm::dot(target, normal)) / tangent;
        if (distance > most.distance) {
            most = {distance, glm::normalize(normal)};
        }
    };
    for (const Moment& moment : m_moments) {
        ask(moment.toRight, moment.right, m_tangentX, moment.forward);
        ask(moment.toLeft, -moment.right, m_tangentX, moment.forward);
        ask(moment.upwards, moment.up, m_tangentY, moment.forward);
        ask(moment.downwards, -moment.up, m_tangentY, moment.forward);
        if (const float behind = glm::dot(target, moment.forward) - moment.along.nearest + kNearest;
            behind > most.distance) {
            most = {behind, -moment.forward};
        }
    }
    return most;
}

Camera Framing::turning() const
{
    glm::vec3 target(0.0F);
    for (const Moment& moment : m_moments) {
        const float x = 0.5F * (moment.toRight - moment.toLeft);
        const float y = 0.5F * (moment.upwards - moment.downwards);
        const float z = 0.5F * (moment.along.nearest + moment.along.farthest);
        target += (x * moment.right + y * moment.up + z * moment.forward) / static_cast<float>(m_moments.size());
    }
    // The least distance over all targets is sought by moving towards whatever asks for most, by ever shorter steps
    // (Badoiu and Clarkson, "Smaller core-sets for balls", 2003).
    constexpr int kSteps = 200;
    constexpr float kFirstStep = 0.25F; // of the distance
    Demand demand = demandAt(target);
    Camera out = m_camera;
    out.target = target;
    out.distance = demand.distance;
    const float reach = kFirstStep * demand.distance;
    for (int step = 1; step <= kSteps; ++step) {
        target += demand.way * (reach / static_cast<float>(step));
        demand = demandAt(target);
        if (demand.distance < out.distance) {
            out.target = target;
            out.distance = demand.distance;
        }
    }
    return out;
}

Camera Framing::camera() const
{
    if (isEmpty()) {
        return m_camera;
    }
    return m_camera.mode == CameraMode::Orbit && m_camera.turntable != 0.0F ? turning() : still();
}

PictureReach Framing::inner() const
{
    const int x = static_cast<int>(0.5F * kMargin * static_cast<float>(m_width));
    const int y = static_cast<int>(0.5F * kMargin * static_cast<float>(m_height));
    return {.left = x, .right = m_width - x, .top = y, .bottom = m_height - y};
}

} // namespace fumage
