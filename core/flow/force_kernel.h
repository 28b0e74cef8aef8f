#pragma once

#include "core/flow/cells.h"
#include "core/flow/step.h"

namespace fumage {

// What accelerates the carried air. Each is called for one plane of cells; planes may run in parallel. The same bits on every instruction set.

/// Heats the air in the source and takes it along: heat becomes at least s heat (1 + unevenness m), where that is not less than 0, with m noise of three octaves, the velocity along its normal goes a share grip s of the way to its own.
/// s is 1 inside and falls to 0 across the rim, which lies at 1 + raggedness n of the reach with n curl noise that moves, root mean square 1.
/// Writes velocity and heat, and divergence: what the source adds by its expansion, everywhere else 0.
void addSource(AirCells& cells, const AirSource& source, int k);

/// Curl of the velocity in plane k, by central differences, and its length, whose ghosts beside the plane are as the cells within.
/// Reads velocity with its ghosts.
void findCurl(const AirCells& cells, int k, CurlPlane& out);

/// forced = velocity + dt (buoyancy heat up + epsilon (N x w)) + change of the wind, with w the curl and N = grad |w| / |grad |w||; then the swirl, what stirs hot air, and friction.
/// Heat cools. Reads velocity, heat and curl.
/// @param curl not read where there is no confinement
/// Source: Steinhoff and Underhill 1994; Fedkiw, Stam, Jensen, "Visual Simulation of Smoke", SIGGRAPH 2001.
void addForces(AirCells& cells, const AirStep& step, int k, const CurlAround& curl);

} // namespace fumage
