#pragma once

#include "core/flow/cells.h"
#include "core/flow/step.h"
#include "core/flow/confinement_budget.h"

namespace fumage {

// What accelerates the carried air. Each is called for one plane of cells; planes may run in parallel. The same bits on
// every instruction set.

/// Curl of the velocity in plane k, by central differences, and its length, whose ghosts beside the plane are as the
/// cells within. Reads velocity with its ghosts.
void findCurl(const AirCells& cells, int k, CurlPlane& out);

/// forced = velocity + dt (buoyancy heat up + epsilon (N x w)) + change of the wind, with w the curl and N = grad |w| /
/// |grad |w||; then the swirl, what stirs hot air, and friction. Heat cools. Reads velocity, heat and curl.
/// @param curl not read where there is no confinement
/// @param work of the confinement, for its budget; not touched where there is none
/// Source: Steinhoff and Underhill 1994; Fedkiw, Stam, Jensen, "Visual Simulation of Smoke", SIGGRAPH 2001.
void addForces(AirCells& cells, const AirStep& step, int k, const CurlAround& curl, ConfinementWork& work);

/// forced less a share of what the confinement has given. Reads velocity, which is as addForces() found it.
/// @param share 0 to 1
void weakenConfinement(AirCells& cells, const AirStep& step, float share, int k, const CurlAround& curl);

/// Squares of what the air's velocity differs from a wind, summed over plane k: of the state of the step before, and of
/// what has been carried.
[[nodiscard]] double motionOfAir(const AirCells& cells, const glm::vec3& wind, int k);
[[nodiscard]] double motionOfCarried(const AirCells& cells, const glm::vec3& wind, int k);

} // namespace fumage
