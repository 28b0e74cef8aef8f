#pragma once

#include "core/effect/effect.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace fumage {

/// How often each grey of a noise texture is seen: what its transparency comes to on average depends on no more.
struct GreyCounts {
    static constexpr std::size_t kGreys = 256;
    std::array<std::uint32_t, kGreys> counts{}; ///< of grey i / 255

    /// The mean of clamp((grey - threshold) / softness, 0, 1): what a texture leaves of opacity where erosion eats at
    /// it.
    /// @param softness more than 0
    /// @return         1 where nothing was counted: no texture takes nothing
    [[nodiscard]] float kept(float threshold, float softness) const;
};

/// What of a disc of its radius and opacity a particle covers, on average over where its texture begins and how it is
/// turned: what light, volumes and neighbours find of it is this times alpha pi r^2.
struct Coverage {
    static constexpr float kSoftDisc = 1.0F / 3.0F; ///< mean over a disc of the soft profile (1 - r^2)^2
    static constexpr int kLives = 64;

    float mean = kSoftDisc; ///< of a newborn particle
    float reach = 1.0F; ///< how far it goes from its centre, in radii
    bool erodes = false;
    std::array<float, kLives + 1>
        left{}; ///< by life, in steps of 1 / kLives: share of what a newborn covers; filled where it erodes
};

/// Mean of maskAt() over the disc of the radius: 1 - 2/3 softness in a disc, 4 / pi in a square, whose corners lie
/// outside of it, and that times the mean alpha in a picture. Closed form of the integral of clamp(u / softness, 0,
/// 1)^2 over u = 1 - r^2 from 0 to 1.
[[nodiscard]] float maskMean(const Look& look);

/// What of an opacity the texture leaves on average; all in a picture, which shows none.
/// @param threshold how far erosion has come: look.erosion times the share of the particle's life that has passed
[[nodiscard]] float textureLeaves(const Look& look, const GreyCounts& greys, float threshold);

/// @param greys of the texture that particles show
[[nodiscard]] Coverage coverageOf(const Look& look, const GreyCounts& greys);

} // namespace fumage
