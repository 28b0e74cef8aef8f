#pragma once

#include "core/base/vector.h"
#include "core/effect/effect.h"

#include <cstdint>

#include <glm/vec3.hpp>

namespace fumage {

struct Birth {
    glm::vec3 position{0.0F}; ///< m
    glm::vec3 velocity{0.0F}; ///< m/s
};

/// Where and how fast particles start: eq. I and II of the 2012 model, with cone and shapes beside.
class BirthPlace {
public:
    /// @param dt seconds a step, over which births between two steps are spread
    BirthPlace(const Emitter& emitter, float dt);

    /// @param key random bits of the particle, see birthKey()
    [[nodiscard]] Birth birth(std::uint32_t key) const;

private:
    [[nodiscard]] glm::vec3 position(std::uint32_t key) const;
    [[nodiscard]] glm::vec3 velocity(std::uint32_t key) const;

    Emitter m_emitter;
    PlaneBasis m_basis;
    float m_spread = 0.0F; ///< radians
    float m_dt = 0.0F;
};

} // namespace fumage
