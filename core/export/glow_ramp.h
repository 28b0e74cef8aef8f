#pragma once

#include "core/rendering/image.h"

#include <array>

#include <glm/vec3.hpp>

namespace fumage {

/// As many as a gradient of Unity has.
inline constexpr int kGlowKeys = 8;

/// What makes a colour of one number that says how much smoke glows: a gradient with keys at even distances, joined
/// linearly. The first is black, and in the brightest channel key k has the square of its position, so that eight bits
/// last for dim fire, too.
struct GlowRamp {
    std::array<glm::vec3, kGlowKeys> colours{}; ///< linear, of positions from 0 to 1, each channel at most 1

    friend bool operator==(const GlowRamp&, const GlowRamp&) = default;
};

/// Position of key k.
[[nodiscard]] constexpr float glowKeyPosition(int k)
{
    return static_cast<float>(k) / (kGlowKeys - 1);
}

/// Where on a ramp a brightness lies.
/// @param brightness of the brightest channel, clamped to [0, 1]
[[nodiscard]] float glowPosition(float brightness);
/// The brightness of a position in [0, 1]: the other way round.
[[nodiscard]] float glowBrightness(float position);
/// The colour of a position in [0, 1].
[[nodiscard]] glm::vec3 glowColour(const GlowRamp& ramp, float position);

/// The ramp whose colours come nearest to those of a picture: at each key the mean hue of what is about as bright, by
/// how much of it is seen.
/// @param emission straight alpha
/// @param scale    its brightest channel; 0: the ramp is black
/// O(pixels). The same bits for any number of threads.
[[nodiscard]] GlowRamp fitGlowRamp(const Image& emission, float scale);

} // namespace fumage
