#pragma once

#include "core/base/float4.h"
#include "core/lighting/appearance.h"
#include "core/lighting/glow.h"
#include "core/lighting/light_field.h"

#include <array>
#include <cstddef>

namespace fumage {

/// Particles that are lit at a time.
inline constexpr std::size_t kLitBlock = 128;

/// The colours of smoke and of what shines on it, and what it gives off itself: with the LightGrid all that makes the
/// colour of a particle.
struct ParticleLight {
    std::array<Float4, kColourTableSize> albedo{}; ///< by life
    std::array<Float4, kGlowTableSize> emission{}; ///< by heat
    Float4 sun{};
    Float4 sky{};
    Float4 ground{};
    Float4 fire{}; ///< colour of the light of what glows
    bool isScattered = false; ///< there is light that was scattered many times
    bool isLitByFire = false;
    bool glows = false;
    GlowTable glow;
    float hotCore = 0.0F;
};

/// @param grid as lightByFire() has left it
/// A quarter of a millisecond for a black body, else some microseconds.
[[nodiscard]] ParticleLight particleLight(const Effect& effect, const LightGrid& grid);

} // namespace fumage
