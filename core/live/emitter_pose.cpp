#include "core/live/emitter_pose.h"

#include "core/base/vector.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace fumage {

namespace {

bool isFinite(const glm::vec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Turns a vector as the shortest turn does that takes one unit vector to another. Source: Rodrigues, with the sine and
/// cosine of the angle from the products of the two.
glm::vec3 turned(const glm::vec3& v, const glm::vec3& from, const glm::vec3& to)
{
    const float cosine = glm::dot(from, to);
    constexpr float kOpposite = -0.999999F; // the axis would be lost in rounding
    if (cosine < kOpposite) {
        const glm::vec3 axis = planeBasis(from).across;
        return 2.0F * glm::dot(v, axis) * axis - v;
    }
    const glm::vec3 axis = glm::cross(from, to);
    return v + glm::cross(axis, v) + glm::cross(axis, glm::cross(axis, v)) / (1.0F + cosine);
}

} // namespace

EmitterPose poseOf(const Emitter& emitter)
{
    return {emitter.position, glm::normalize(emitter.normal), glm::vec3(0.0F)};
}

Result<EmitterPose> checkedPose(const EmitterPose& pose)
{
    if (!isFinite(pose.position) || !isFinite(pose.normal) || !isFinite(pose.velocity)) {
        return Error{ErrorCode::OutOfRange, makeMessage("the emitter's place or velocity is no number"), {},
            makeMessage("Pass finite numbers")};
    }
    const float longest = std::max({std::abs(pose.normal.x), std::abs(pose.normal.y), std::abs(pose.normal.z)});
    if (longest == 0.0F) {
        return Error{ErrorCode::OutOfRange, makeMessage("the emitter's normal has no direction"), {},
            makeMessage("Pass a normal that is not zero")};
    }
    return EmitterPose{pose.position, glm::normalize(pose.normal / longest), pose.velocity};
}

EmitterPose between(const EmitterPose& from, const EmitterPose& to, double share)
{
    if (share >= 1.0) {
        return to;
    }
    const auto t = static_cast<float>(share);
    EmitterPose out{glm::mix(from.position, to.position, t), to.normal, glm::mix(from.velocity, to.velocity, t)};
    if (from.normal != to.normal && !areAlmostOpposite(from.normal, to.normal)) {
        out.normal = glm::normalize(glm::mix(from.normal, to.normal, t));
    }
    return out;
}

EmitterPose carriedAlong(const EmitterPose& own, const EmitterPose& from, const EmitterPose& to)
{
    return {to.position + turned(own.position - from.position, from.normal, to.normal),
        glm::normalize(turned(own.normal, from.normal, to.normal)), to.velocity};
}

} // namespace fumage
