#pragma once

#include "core/fumage.h"
#include "core/live/live_scene.h"

#include <exception>
#include <optional>
#include <string>

struct fumage_smoke {
    std::optional<fumage::LiveScene> scene; ///< none: it did not start
    std::optional<std::string> error; ///< of the last call that could fail
    bool outOfMemory = false; ///< and no text could be kept
};

// What the functions of fumage.h have in common.
namespace fumage::c {

/// Keeps an error for fumage_error().
inline void keep(fumage_smoke& smoke, const Error& error)
{
    smoke.error = error.text();
}

/// Runs what may throw: nothing does on purpose, but memory may end.
/// @return what body returns, or failed
template <class T, class Body>
T guarded(fumage_smoke& smoke, T failed, const Body& body) noexcept
{
    try {
        return body();
    } catch (const std::exception& exception) {
        try {
            smoke.error = exception.what();
        } catch (...) {
            smoke.outOfMemory = true;
        }
    } catch (...) {
        smoke.outOfMemory = true;
    }
    return failed;
}

inline bool isRunning(const fumage_smoke* smoke)
{
    return smoke != nullptr && smoke->scene.has_value();
}

/// The same for a call that could fail, of a smoke that has started; NULL, and one that has not, fail and keep their
/// error.
template <class T, class Body>
T running(fumage_smoke* smoke, T failed, const Body& body) noexcept
{
    if (!isRunning(smoke)) {
        return failed;
    }
    smoke->error.reset();
    smoke->outOfMemory = false;
    return guarded(*smoke, failed, [&] { return body(*smoke->scene); });
}

inline int resultOf(fumage_smoke& smoke, const Status& status)
{
    if (status) {
        return 0;
    }
    keep(smoke, status.error());
    return -1;
}

inline glm::vec3 vectorOf(const float* numbers)
{
    return numbers == nullptr ? glm::vec3(0.0F) : glm::vec3(numbers[0], numbers[1], numbers[2]);
}

inline std::optional<glm::vec3> eyeOf(const float* numbers)
{
    return numbers == nullptr ? std::nullopt : std::optional(vectorOf(numbers));
}

/// A pose in place of another; NULL leaves place and normal as they are, and is no velocity.
inline EmitterPose poseFrom(EmitterPose pose, const float* position, const float* normal, const float* velocity)
{
    pose.position = position == nullptr ? pose.position : vectorOf(position);
    pose.normal = normal == nullptr ? pose.normal : vectorOf(normal);
    pose.velocity = vectorOf(velocity);
    return pose;
}

/// The first number of a column that is found when it is asked for, or NULL; of a muted layer there is none.
/// @param column Result<std::span<...>> of vectors
template <class Column>
const float* firstOf(fumage_smoke& smoke, const Column& column)
{
    if (!column) {
        keep(smoke, column.error());
        return nullptr;
    }
    return column.value().empty() ? nullptr : &column.value().front().x;
}

/// Particles of a layer, as far as they are to be drawn.
inline std::size_t slotsOf(const LiveScene& scene, std::size_t layer)
{
    return scene.isVisible(layer) ? scene.particles(layer).capacity : 0;
}

} // namespace fumage::c
