#include "core/simulation/chunk_step.h"

#include "core/simulation/air_kernel.h"
#include "core/simulation/step.h"

namespace fumage {

Particles::Columns columnsOf(const Model& model)
{
    const Look& look = model.effect()->look;
    return {.rolls = look.roll > 0.0F, .inAir = model.inAir(), .deforms = model.inAir() && look.deformation > 0.0F};
}

void moveChunk(const StepConstants& constants, Particles& particles, std::size_t chunk)
{
    const auto move = constants.air.field != nullptr ? &carryChunk : &stepChunk;
    move(constants, particles, chunk);
}

void bearInChunk(const BirthPlace& place, const StepConstants& constants, std::int64_t randomIndex, std::size_t slot, std::size_t end, Particles& particles)
{
    particles.clearRoll(slot, end);
    bearParticles(place, randomIndex, constants.step, slot, end - slot, particles);
    if (constants.air.field != nullptr) {
        carryNewborns(constants, particles, slot, end);
    } else if (constants.betweenSteps) {
        stepNewborns(constants, particles, slot, end);
    }
}

} // namespace fumage
