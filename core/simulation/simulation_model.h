#pragma once

#include "core/effect/effect.h"
#include "core/flow/air.h"
#include "core/noise/curl_slices.h"
#include "core/simulation/emitter.h"
#include "core/simulation/schedule.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include <glm/vec3.hpp>

namespace fumage {

/// Fastest that a particle may be in each component, m/s: forces that grow with distance would else end in infinity,
/// and then in no number.
inline constexpr float kMaxSpeed = 1e6F;

/// One octave of turbulence at one step: two slices of time that cross-fade and drift together.
struct OctaveAtStep {
    float frequency = 1.0F; ///< relative to the first octave
    glm::vec3 shift{0.0F}; ///< of places against its lattice, in units of it; along y less the part of the drift that
                           ///< is no whole number of them
    CurlSlices slices; ///< weights in m/s, with the normalisation of the noise
    bool turns = false; ///< whether its swirls turn particles
};

/// The air of a step, and what stands in it.
struct AirConstants {
    const AirField* field = nullptr; ///< null: no air carries the particles
    float reach = 1.0F; ///< beyond the box the air goes over into the wind within this, m
    float detail = 0.0F; ///< speed of the swirls below the grid, for each m/s that the air differs from cell to cell
    glm::vec3 sourceDepth{0.0F}; ///< along it particles are born, as far as this in its middle, m
    std::array<glm::vec3, 2> sourceSides{}; ///< at right angles to it, over the source's reach along them: 1/m
    glm::vec3 sourceVelocity{0.0F}; ///< of the air that particles are born in, m/s
    bool hasGround = false;
    float groundHeight = 0.0F;
    Obstacle obstacle = Obstacle::None;
    glm::vec3 obstaclePosition{0.0F};
    glm::vec3 obstacleHalf{0.0F}; ///< half its edges, or its radius in x
    bool obstacleMoves = false;
    glm::vec3 obstacleVelocity{0.0F}; ///< of its centre, m/s
    glm::vec3 obstacleGrowth{0.0F}; ///< see Solid
    float shapeLost = 0.0F; ///< how much of a particle's deformation goes in a step
    Coupling coupling = Coupling::Carried;
    bool bornOnParent = false; ///< and not in a source of the air
    bool bornOnPicture = false; ///< which is not drawn together towards its middle, or nobody would know it
    float restitution = 0.0F; ///< of what is not carried
    float friction = 0.0F;
};

/// Everything about a step that is the same for all particles.
struct StepConstants {
    std::uint32_t key = 0;
    float dt = 0.0F;
    std::int32_t step = 0;
    float share = 1.0F; ///< of the step's time that dt is
    float rest = 0.0F; ///< share of it that is left to other parts afterwards
    bool betweenSteps = false; ///< whether particles are born between steps, see Schedule

    bool plain = true; ///< nothing but the terms of the 2012 model without rotation
    glm::vec3 steady{0.0F}; ///< a (1 - r) tau of wind and gravity, m/s, with tau the time for which acceleration lasts,
                            ///< see draggedTime()
    glm::vec3 random{0.0F}; ///< a r tau, times sqrt(steps a frame) 2^-31: multiplies a random int32

    float steadyShare = 1.0F; ///< 1 - r
    float randomShare = 0.0F; ///< r, times sqrt(steps a frame) 2^-31
    float buoyancy = 0.0F; ///< times tau, m/s
    float cooling = 0.0F;
    float heatVariance = 0.0F;
    float pull = 0.0F; ///< times tau, 1/s
    float drag = 0.0F; ///< times tau: the share of its velocity that a particle loses
    float dragOfStep = 0.0F; ///< times dt
    float flightBefore = 0.0F; ///< what the velocities before and after a step have in the way of it
    float flightAfter = 1.0F;
    glm::vec3 pivot{0.0F}; ///< the emitter
    float rotation = 0.0F; ///< of the whole cloud, radians
    float rotationSin = 0.0F;
    float rotationCos = 1.0F;

    float vortexStrength = 0.0F;
    float vortexRadius = 1.0F; ///< at the pivot, m
    float vortexWidening = 0.0F; ///< of the radius, m for each along the axis
    glm::vec3 vortexAxis{0.0F, 1.0F, 0.0F};

    float ringStrength = 0.0F;
    float ringRadius = 1.0F;
    float ringWidening = 0.0F;
    float ringsPerMetre = 1.0F;
    float ringCentre = 0.0F; ///< distance of a ring from the emitter, m
    float ringNumber = 0.0F; ///< of that ring, counted from the first that left
    float ringsInLoop = 0.0F; ///< after which their numbers come again; 0: never
    bool ringsLead = false; ///< whether ring 0 is the first, with still air before it
    float ringFollowers = 1.0F; ///< strength of all but ring 0
    float ringVariance = 0.0F;
    std::uint32_t ringKey = 0;
    glm::vec3 ringAxis{0.0F, 1.0F, 0.0F};
    std::array<glm::vec3, 2> ringSides{}; ///< at right angles to the axis

    int octaves = 0;
    float turbulenceFrequency = 1.0F; ///< 1/m, of the first octave
    float onset = 0.0F;
    float growth = 0.0F;
    std::array<OctaveAtStep, kMaxTurbulenceOctaves> octave{};

    AirConstants air;
};

/// How a layer lies in its scene, whose air and wind have a clock of their own.
struct LayerClock {
    std::int64_t stepsBehind = 0; ///< the air's step less the layer's
    std::uint32_t windSeed = 0; ///< of the gusts, which all layers feel
    friend bool operator==(const LayerClock&, const LayerClock&) = default;
};

/// An effect as the simulation sees it: schedule and constants in base units.
class SimulationModel {
public:
    /// @param air that carries the particles, of the same effect; null where none does
    explicit SimulationModel(const SampledEffect& effect, std::shared_ptr<BakedAir> air = nullptr);
    /// The same of a layer of a scene, whose air several feed.
    SimulationModel(const SampledEffect& effect, const LayerClock& clock, std::shared_ptr<BakedAir> air = nullptr);

    /// An effect whose air somebody else computes, step by step, on a grid of his own; air() is then nullptr.
    SimulationModel(const SampledEffect& effect, const AirGrid& grid);
    /// The same of a layer of a scene.
    SimulationModel(const SampledEffect& effect, const LayerClock& clock, const AirGrid& grid);

    [[nodiscard]] const SampledEffect& effect() const { return m_effect; }
    /// The effect as it is at a step: with what changes over time and is read at a step, at a birth, or as a rate.
    /// @param room for it, where anything does; it has to outlive what is returned
    /// @param step parts of steps too
    [[nodiscard]] const SampledEffect& effectAt(double step, std::optional<SampledEffect>& room) const;
    /// The effect with each number that changes over time at its greatest: what is as often as it is in the effect may
    /// not be more often at one time than at another.
    [[nodiscard]] const SampledEffect& strongest() const { return m_strongest ? *m_strongest : m_effect; }
    /// Whether a value jumps between two steps, or is another at the end of a loop than at its beginning and they lie
    /// on either side of it.
    /// @param from,to parts of steps too
    [[nodiscard]] bool jumpsBetween(const Parameter& row, double from, double to) const;
    /// What gives birth at a step: the emitter as it is then, and how it has come there.
    [[nodiscard]] Spawner spawnerAt(std::int64_t step) const;
    /// Where a step lies among the puffs of a source that surges.
    [[nodiscard]] RowPosition surgeAt(double step) const;

    /// Puts the emitter elsewhere, and turns it. Where air is baked it is that of the place before: for models whose
    /// air is computed step by step, or none. Costs nothing: when particles are born and how noise moves does not
    /// depend on it.
    void placeEmitter(const glm::vec3& position, const glm::vec3& normal) { m_effect.placeEmitter(position, normal); }

    /// Lets the turbulence go on from where that of another model is at a step, whose rates were others: for models
    /// whose parameters somebody sets while they run. Neither loops, nor has rates that change over time.
    void continueFrom(const SimulationModel& before, std::int64_t step);

    /// Lets the particles be born on those of another layer, in the same air.
    void setParent(std::shared_ptr<const SimulationModel> parent);
    /// The layer on whose particles they are born; null: on the emitter.
    [[nodiscard]] const std::shared_ptr<const SimulationModel>& parent() const { return m_parent; }
    /// The parent's step at a step of the particles; in a loop one at which it is warm. Below 0 it has not begun.
    [[nodiscard]] std::int64_t parentStep(std::int64_t step) const { return step + m_parentAhead; }

    /// Whether air carries the particles, baked or not.
    [[nodiscard]] bool inAir() const { return m_grid.has_value(); }

    /// When particles are born and for how long they live.
    [[nodiscard]] const Schedule& schedule() const { return m_schedule; }

    /// The baked air that carries the particles, or nullptr.
    [[nodiscard]] BakedAir* air() const { return m_air.get(); }
    /// The step of that air at a step of the particles.
    [[nodiscard]] std::int64_t airStep(std::int64_t step) const { return step + m_clock.stepsBehind; }
    [[nodiscard]] const LayerClock& clock() const { return m_clock; }

    /// What moves particles from step - 1 to step; without the air's field, which has to be computed first.
    /// @param share of the step's time, for a part of it
    [[nodiscard]] StepConstants constants(std::int64_t step, float share = 1.0F) const;

    /// Wind acceleration with its gusts at a step, m/s^2: (Vw cos theta, 0, Vw sin theta), eq. III and V.
    /// @param step of the particles; parts of steps too
    [[nodiscard]] glm::vec3 windAt(double step) const;

    /// Angle by which the whole cloud turns in one step, radians: particles and their velocities, not the emitter. The
    /// emitter is the ground that smoke rises from; and its angle would be the sum of all draws since step 0, so that
    /// no frame could be had without those before it.
    [[nodiscard]] float rotationAt(std::int64_t step) const;

private:
    /// Smooth random value in [-1, 1] of the time of the wind; whole in a loop.
    [[nodiscard]] float gustAt(double step, std::uint32_t stream) const;
    /// What random numbers that are drawn anew every step are multiplied by. The source draws once a frame; the sum of
    /// n draws in a frame spreads as far as one of them times sqrt(n), and n steps of a frame are each n times shorter.
    [[nodiscard]] float drawScale() const;
    /// @param turbulence with the rates by which its slices are counted
    /// @param faster than those it changes
    [[nodiscard]] OctaveAtStep octaveAt(
        const Turbulence& turbulence, float faster, std::int64_t step, int octave) const;
    /// Whether turbulence becomes another: in a loop, also where it only drifts.
    [[nodiscard]] bool evolves() const;
    /// Which slices of time an octave is between.
    /// @param cellsPerStep where nothing changes its rate
    /// @param faster than the parameter says it changes
    [[nodiscard]] RowPosition evolvedTo(std::int64_t step, double cellsPerStep, double faster) const;
    /// How far an octave has risen, in units of its lattice.
    struct Drift {
        double now = 0.0;
        double perStep = 0.0; ///< by the rate by which slices are counted
        double inLoop = 0.0; ///< whole
    };
    /// @param drift by which slices are counted
    [[nodiscard]] Drift driftedTo(float drift, std::int64_t step, double latticePerMetre) const;
    void placeRings(const Effect& now, std::int64_t step, StepConstants& out) const;
    void placeAir(const Effect& now, StepConstants& out) const;
    void placeTurbulence(const Effect& now, std::int64_t step, StepConstants& out) const;
    /// Rings that have passed since step 0.
    [[nodiscard]] double ringsPassed(std::int64_t step, StepConstants& out) const;
    /// The sums of all rates that change over time.
    void sumRates();

    SampledEffect m_effect;
    LayerClock m_clock;
    Schedule m_schedule;
    /// How turbulence moves.
    struct Pace {
        float drift = 0.0F; ///< by which slices are counted, m/s
        float evolution = 0.0F; ///< Hz
        double drifted = 0.0; ///< what it has drifted, of rates before, beyond what those now make of all time, m
        double evolved = 0.0; ///< turns
    };
    Pace m_pace;
    std::shared_ptr<BakedAir> m_air;
    std::shared_ptr<const SimulationModel> m_parent;
    std::int64_t m_parentAhead = 0; ///< its step less that of the particles
    std::optional<AirGrid> m_grid; ///< of the air that carries the particles; none where none does
    bool m_changes = false; ///< whether anything of a step does over time
    std::optional<SampledEffect> m_strongest; ///< none: nothing changes over time
    std::optional<RateSum> m_drift; ///< of rates that change over time
    std::optional<RateSum> m_evolution;
    std::optional<RateSum> m_gusts;
    std::optional<RateSum> m_surges;
    std::optional<RateSum> m_rings;
};

} // namespace fumage
