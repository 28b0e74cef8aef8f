#pragma once

#include "core/simulation/simulation_model.h"
#include "core/simulation/particles.h"

#include <span>

namespace fumage {

/// stepChunk() where air carries the particles: the motion of smoke and of what falls through it.
///
/// With u the air at a place, n curl noise of the air's own strength there, and r the velocity relative to the air, all
/// as in stepChunk(): r += (gravity + differences of heat + pull - D r) tau, then P += (u(P + dt/2 (u(P) + r)) + r +
/// n(P)) dt. No particle enters ground or obstacle: it is put onto the surface and keeps what velocity it has along it.
/// What is dragged has r = v - u(P) with a velocity v of its own, keeps to it and bounces: P += (u(P) + r) dt; what is
/// free the same with u = 0. Where they deform, C follows the flow's gradient G: dC/dt = G C + C G^T - (C - 1) / tau,
/// the squares of a particle's axes as a tensor. Source of the noise's strength: Kim, Thürey, James, Gross, "Wavelet
/// Turbulence for Fluid Simulation", SIGGRAPH 2008, by the local gradient.
/// @param constants with the air of the step
void carryChunk(const StepConstants& constants, Particles& particles, std::size_t chunk);

/// stepNewParticles() where air carries the particles; also where none are born between steps, since they start in
/// moving air.
/// @param parts of the step, one or more, each with its air: those born between them go through what is left
/// @param way that the emitter took in the step, along which they were born, m
void carryNewParticles(std::span<const StepConstants> parts, const glm::vec3& way, Particles& particles,
    std::size_t first, std::size_t last);

} // namespace fumage
