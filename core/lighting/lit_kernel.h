#pragma once

#include "core/lighting/particle_light.h"
#include "core/simulation/particles.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace fumage {

/// Constants of one pass over the particles.
struct LitJob {
    const Particles* particles = nullptr;
    const Appearance* appearance = nullptr;
    const LightGrid* grid = nullptr;
    ParticleLight colours;
    std::int32_t step = 0;
    float dt = 0.0F;
    bool bornBetweenSteps = false;
};

/// Fills the colours of particles [begin, begin + kLitBlock).
/// @param begin a multiple of kLitBlock
/// @param out   the first of them
void litColoursOfBlock(const LitJob& job, std::size_t begin, glm::vec4* out);

/// Constants of one pass over the particles.
struct NormalJob {
    const Particles* particles = nullptr;
    const Appearance* appearance = nullptr;
    const GridShape* shape = nullptr;
    const AlignedArray<float>* outwards = nullptr; ///< as in NormalWorkspace
};

/// The same for normals.
void normalsOfBlock(const NormalJob& job, std::size_t begin, glm::vec3* out);

} // namespace fumage
