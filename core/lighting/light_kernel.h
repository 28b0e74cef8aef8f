#pragma once

#include "core/lighting/light_field.h"
#include "core/lighting/sun_job.h"
#include "core/simulation/frame.h"

namespace fumage {

/// Adds the particles of one chunk to a fixed-point density.
/// @param unitsPerMass factor from m^2 to whole numbers
void splatChunk(const Particles& particles, const Appearance& appearance, const GridShape& shape, float unitsPerMass,
    std::size_t chunk, std::uint32_t* density);

/// One of the six directions along the grid's axes from which light of sky and ground comes.
struct AmbientDirection {
    int axis = 0; ///< 0 u, 1 v, 2 w
    bool reversed = false; ///< light travels towards lower indices
    float sky = 0.0F; ///< weight in the light of the sky
    float ground = 0.0F;
};

/// Adds weight * exp(-tau) along one direction to the sky and ground channels of the lines of one index.
/// @param line for axes u and v, the plane along w; for axis w, the row along v
void addAmbient(
    const LightGrid& grid, const AmbientDirection& direction, float occlusion, int line, LightWorkspace& to);

/// @param eye the camera, m
[[nodiscard]] SunJob sunJob(const Light& light, const Axes& axes, const glm::vec3& eye);

/// Sums optical depth along w for one row along v, and fills all four channels of its cells.
/// @param from with sky and ground done
void addSun(const LightWorkspace& from, const SunJob& job, int row, LightGrid& grid);

} // namespace fumage
