#pragma once

#include "core/effect/effect.h"
#include "core/noise/detail_texture.h"
#include "core/simulation/advected_coordinates.h"

#include <array>

#include <glm/vec3.hpp>

namespace fumage {

/// Whether an effect shows detail that its air carries.
[[nodiscard]] bool hasDetail(const Effect& effect);

/// Makes the weighted sum of two noises even again, each of which is even in [-1, 1]: with weights a >= b the sum c is
/// spread as a trapezoid, whose share below c, as a number from -1 to 1, is c / a up to |c| = a - b, and beyond it less
/// by (|c| - (a - b))^2 / (4 a b).
struct PhaseBlend {
    float gain = 1.0F;
    float flat = 2.0F; ///< a - b
    float bend = 0.0F; ///< 1 / (4 a b)

    PhaseBlend() = default;
    PhaseBlend(float one, float other);

    [[nodiscard]] float operator()(float sum) const;
};

/// How the two phases come together.
enum class PhaseMix {
    Blend, ///< each particle shows the sum of both
    /// Each shows one, as do its neighbours, and small ones a sample of it: half the work, a little less contrast, and
    /// changes that are seen. For pictures that move
    Choose,
};

/// A phase of less than this weight is not looked at.
inline constexpr float kMinPhaseWeight = 0.02F;

/// The noise of an effect that rides on its air, as sprites and light read it.
struct DetailField {
    /// @param effect with hasDetail()
    /// @param coordinates at the step of the picture; outlive it
    DetailField(const Effect& effect, const AdvectedCoordinates& coordinates, PhaseMix phaseMix = PhaseMix::Blend);

    const std::array<AdvectedPhase, 2>* phases;
    PhaseMix mix;
    const DetailTexture* texture = &DetailTexture::instance();
    std::array<glm::vec3, 2> shift{}; ///< of each phase, tiles: no two seeds show the same noise
    float wave = 1.0F; ///< the longest, m
    float tilesPerMetre = 1.0F;
    float strength = 0.0F; ///< by how much alpha changes, of its own
    float edge = 0.0F; ///< share of it that is left in thin smoke
    float relief = 0.0F;
    float shadow = 0.0F; ///< by how much the mass changes that throws shadow, of its own
};

/// Whether two change the mass that throws shadow in the same way.
[[nodiscard]] bool shadowsAlike(const DetailField& one, const DetailField& other);

} // namespace fumage
