#include "core/simulation/chunk_step.h"

#include "core/effect/known_parameter.h"
#include "core/simulation/air_kernel.h"
#include "core/simulation/step.h"

namespace fumage {

Particles::Columns columnsOf(const SimulationModel& model)
{
    const SampledEffect& effect = model.effect();
    const bool rolls = effect->look.roll > 0.0F || effect.changes(knownParameter("look.roll"));
    const bool deforms = effect->look.deformation > 0.0F || effect.changes(knownParameter("look.deformation"));
    return {.rolls = rolls, .inAir = model.inAir(), .deforms = model.inAir() && deforms};
}

namespace {

/// An obstacle as the air that flows around it has it, which knows how it moves.
void placeObstacle(const Solid& obstacle, AirConstants& air)
{
    air.obstaclePosition = obstacle.centre;
    air.obstacleHalf = 0.5F * obstacle.size;
    air.obstacleMoves = obstacle.moves();
    air.obstacleVelocity = obstacle.velocity;
    air.obstacleGrowth = obstacle.growth;
}

} // namespace

void findParts(const SimulationModel& model, std::int64_t step, const AirField* air, std::vector<StepConstants>& out)
{
    out.clear();
    if (air == nullptr) {
        out.push_back(model.constants(step));
        return;
    }
    float rest = 1.0F;
    const auto add = [&](const AirField& field) {
        StepConstants& part = out.emplace_back(model.constants(step, field.share));
        rest -= field.share;
        part.rest = rest;
        part.air.field = &field;
        if (field.obstacle) {
            placeObstacle(*field.obstacle, part.air);
        }
    };
    for (const AirField& field : air->earlier) {
        add(field);
    }
    add(*air);
    out.back().rest = 0.0F; // whatever has been rounded
}

void moveChunk(std::span<const StepConstants> parts, Particles& particles, std::size_t chunk)
{
    for (const StepConstants& constants : parts) {
        const auto move = constants.air.field != nullptr ? &carryChunk : &stepChunk;
        move(constants, particles, chunk);
    }
}

namespace {

/// Takes particles that were born at the emitter to those that they are born on.
void takeAlong(std::span<const SubEmission> on, std::size_t slot, Particles& particles)
{
    for (const SubEmission& place : on) {
        particles.x[slot] += place.away.x;
        particles.y[slot] += place.away.y;
        particles.z[slot] += place.away.z;
        particles.vx[slot] += place.velocity.x;
        particles.vy[slot] += place.velocity.y;
        particles.vz[slot] += place.velocity.z;
        ++slot;
    }
}

} // namespace

void spawnInChunk(const Spawner& place, std::span<const StepConstants> parts, std::int64_t randomIndex,
    std::size_t slot, std::size_t end, std::span<const SubEmission> on, Particles& particles)
{
    const StepConstants& constants = parts.back();
    particles.clearRoll(slot, end);
    spawnParticles(place, randomIndex, constants.step, slot, end - slot, particles);
    takeAlong(on, slot, particles);
    if (constants.air.field != nullptr) {
        carryNewParticles(parts, place.travel.way, particles, slot, end);
    } else if (constants.betweenSteps) {
        stepNewParticles(constants, particles, slot, end);
    }
    for (std::size_t i = 0; i < on.size(); ++i) {
        if (!on[i].isThere) {
            particles.clear(slot + i, slot + i + 1);
        }
    }
}

} // namespace fumage
