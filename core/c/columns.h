#pragma once

#include "core/live/live_scene.h"

// The columns of a layer as C has them: a pointer to the first number. The layer is one that is to be drawn.
namespace fumage::c {

using Column = const float* (*)(LiveScene& scene, std::size_t layer);

inline constexpr Column kX = [](LiveScene& scene, std::size_t layer) { return scene.particles(layer).x.data(); };
inline constexpr Column kY = [](LiveScene& scene, std::size_t layer) { return scene.particles(layer).y.data(); };
inline constexpr Column kZ = [](LiveScene& scene, std::size_t layer) { return scene.particles(layer).z.data(); };
inline constexpr Column kVelocityX = [](LiveScene& scene, std::size_t layer) {
    return scene.particles(layer).vx.data();
};
inline constexpr Column kVelocityY = [](LiveScene& scene, std::size_t layer) {
    return scene.particles(layer).vy.data();
};
inline constexpr Column kVelocityZ = [](LiveScene& scene, std::size_t layer) {
    return scene.particles(layer).vz.data();
};
inline constexpr Column kRadius = [](LiveScene& scene, std::size_t layer) {
    return scene.appearance(layer).radius.data();
};
inline constexpr Column kLife = [](LiveScene& scene, std::size_t layer) { return scene.appearance(layer).life.data(); };
inline constexpr Column kAge = [](LiveScene& scene, std::size_t layer) { return scene.ages(layer).data(); };
inline constexpr Column kColour = [](LiveScene& scene, std::size_t layer) -> const float* {
    return &scene.colours(layer).front().x;
};

} // namespace fumage::c
