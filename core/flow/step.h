#pragma once

#include "core/base/vector.h"
#include "core/effect/effect.h"
#include "core/flow/solid.h"
#include "core/noise/curl_slices.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace fumage {

/// One octave of noise that moves: of a source, or of what stirs the air.
struct AirOctave {
    float frequency = 1.0F; ///< 1/m
    glm::vec3 shift{0.0F};
    CurlSlices slices;
};

/// Where heat and momentum enter the air: the emitter's shape, with a rim that is soft, ragged and moves.
struct AirSource {
    bool acts = false;
    EmitterShape shape = EmitterShape::Disc; ///< a picture is on a rectangle
    Bitmap picture; ///< where it is dark the source gives nothing; none: it gives as much everywhere
    glm::vec3 place{0.0F};
    glm::vec3 normal{0.0F, 1.0F, 0.0F};
    PlaneBasis basis;
    glm::vec2 reach{1.0F}; ///< half its edges across and along, or its radius twice, m
    float depth = 0.0F; ///< along the normal, m; a sphere has none
    float softness = 1.0F; ///< width of the rim, m
    float raggedness = 0.0F; ///< how far the rim wanders, as a share of the reach
    float speed = 0.0F; ///< of what comes out, along the normal, m/s
    float relaxation = 0.0F; ///< share of the way to that speed in a step
    float heat = 0.0F;
    float expansion = 0.0F; ///< divergence within, 1/s
    float unevenness = 0.0F; ///< how far its heat varies, as a share of it
    std::array<AirOctave, 2> rim;
    AirOctave billow; ///< the smallest, which only its heat has
    glm::ivec3 first{0}; ///< cells that it may reach: [first, last), along x multiples of kAirLanes
    glm::ivec3 last{0};
};

/// A vortex that turns the air about an axis: its speed is 2 s / (1 + s^2) of the fastest, s = distance / radius
/// (Scully 1975).
struct AirVortex {
    float speed = 0.0F; ///< where it is fastest, m/s; 0: none
    float radius = 1.0F; ///< at which it is, beside the place, m
    float widening = 0.0F; ///< of the radius, m for each along the axis
    glm::vec3 place{0.0F}; ///< on the axis
    glm::vec3 axis{0.0F, 1.0F, 0.0F};
    float relaxation = 0.0F; ///< share of the way to its speed in a step
};

/// Most octaves of what stirs the air.
inline constexpr std::size_t kForcingOctaves = 3;

/// A force of curl noise on all that is hot: what the wind, the fire and what burns do to smoke at scales that the
/// source does not know of.
struct TurbulenceForcing {
    float strength = 0.0F; ///< root mean square of the acceleration at heat 1, m/s^2; 0: none
    std::size_t octaves = 0; ///< the largest ones, which the grid can show
    std::array<AirOctave, kForcingOctaves> octave;
    glm::vec3 place{0.0F}; ///< of the source, m
    float calm = 1.0F; ///< distance from it at which the force begins, m; at twice of it all of it acts
};

/// What one of several emitters does to the air beside its source.
struct AirFeed {
    AirSource source;
    AirVortex vortex;
};

/// What happens to the air in one step, or in the last part of one that is too long or too violent to be taken at once.
struct AirStep {
    float dt = 0.0F; ///< of a piece, s
    int pieces = 1; ///< that it is taken in, all alike
    float share = 1.0F; ///< of the time of the whole step
    std::vector<AirStep> earlier; ///< the parts before it; their shares and its own make 1
    float buoyancy = 0.0F; ///< upward acceleration at heat 1, m/s^2
    float heatKept = 1.0F; ///< share of the heat that is left after the step
    float confinement = 0.0F; ///< epsilon of Steinhoff and Underhill
    float friction = 0.0F; ///< drag coefficient of ground and obstacles
    glm::vec3 wind{0.0F}; ///< of the air outside, m/s
    glm::vec3 windChange{0.0F}; ///< in a piece; all of the air is moved by as much
    AirSource source;
    AirVortex vortex;
    std::vector<AirFeed> others; ///< further emitters: where sources overlap, the hottest counts, and expansions add
    TurbulenceForcing forcing;
    /// What stands in the air at its end, in place of all solids that were there, and moves as it has in it; none: they
    /// stay as they are
    std::optional<Solid> obstacle;

    /// Whether a source gives anything off.
    [[nodiscard]] bool acts() const
    {
        return source.acts
            || std::any_of(others.begin(), others.end(), [](const AirFeed& feed) { return feed.source.acts; });
    }
};

} // namespace fumage
