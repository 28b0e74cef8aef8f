#pragma once

#include "core/base/result.h"
#include "core/lighting/appearance.h"
#include "core/live/birth_clock.h"
#include "core/live/emitter_pose.h"
#include "core/simulation/air_step.h"
#include "core/simulation/frame.h"
#include "core/simulation/sub_emission.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace fumage {

/// A layer of smoke that steps with a game: its emitter, its births, its particles and how they look. Who owns it has
/// the clock and the air, and says when it goes on; see LiveScene.
///
/// A layer counts its own steps, from 0 at emitter.start: before that it has none. Not thread-safe, uses all threads
/// inside.
class LiveLayer {
public:
    /// @param emitter where it begins
    explicit LiveLayer(const Emitter& emitter);

    /// The layer on whose particles its own are born. Both have a model, and it is set before the first step.
    void setParent(LiveLayer& parent);
    /// Takes what its particles do from now on; living ones go on from where they are.
    /// @param next     the step of the scene that comes next
    /// @param windSeed of the gusts, which all layers feel
    /// @param grid     of the air that carries the particles; null: none
    /// Allocates only where particles begin to roll, or to be deformed.
    void setEffect(const SampledEffect& effect, std::int64_t next, std::uint32_t windSeed, const AirGrid* grid);
    /// Makes room for particles, of which there are none then.
    void makeRoom(std::int64_t places);

    /// Where the emitter is at the end of the way.
    void setTarget(const EmitterPose& target) { m_target = target; }
    /// Puts it there at once.
    void placeAtTarget() { m_pose = m_reached = m_target; }
    /// The same of its position alone, and of its normal.
    void jumpToPosition() { m_pose.position = m_reached.position = m_target.position; }
    void jumpToNormal() { m_pose.normal = m_reached.normal = m_target.normal; }
    [[nodiscard]] const EmitterPose& target() const { return m_target; }
    /// Lets it have come there.
    void arrive() { m_reached = m_target; }

    /// The share of its births, 0 to 1 (clamped; 0 is a switch).
    void setShare(float share) { m_share = share > 0.0F ? std::min(share, 1.0F) : 0.0F; }
    /// The share of births now.
    /// @param scene,budget what the scene, and its budget, leave of them
    [[nodiscard]] float share(float scene, float budget) const
    {
        return scene * m_share * std::min(budget, placesShare());
    }
    /// An effect of bursts bursts again.
    void burst() { m_clock.restart(); }

    /// What of the emitter's pose key frames say for each step.
    struct KeyedPose {
        bool position = false;
        bool normal = false;
    };
    /// Begins a step: the emitter goes on along its way.
    /// @param step  of the scene
    /// @param share of the way to the target
    /// @param keyed of it what is at the target with this step
    void begin(std::int64_t step, double share, const KeyedPose& keyed);
    /// What it does to the air of the step that has begun.
    /// @param step  of the scene
    /// @param share of births now
    [[nodiscard]] AirFeeder feeder(std::int64_t step, float share) const;
    /// Finds what moves the particles in the step.
    /// @param air of the step, or nullptr
    void plan(const AirField* air);
    /// Moves the particles, and ends the step. A layer that it is born on has ended it before.
    /// @param share of births now
    void move(float share);

    /// Particles that have been born and not died.
    [[nodiscard]] std::size_t living() const { return static_cast<std::size_t>(m_next - m_first - m_absent); }
    [[nodiscard]] const Frame& frame() const { return m_frame; }
    [[nodiscard]] const Particles& particles() const { return m_frame.particles; }
    /// With its quality worked in, and the emitter where it is.
    [[nodiscard]] const SampledEffect& effect() const { return m_model->effect(); }
    [[nodiscard]] const Schedule& schedule() const { return m_model->schedule(); }

    // What was found of the particles of a step, on the first call after it; one number a slot.

    [[nodiscard]] const Appearance& appearance();
    [[nodiscard]] std::span<const glm::vec4> colours();
    [[nodiscard]] std::span<const float> ages();
    [[nodiscard]] std::span<const std::uint64_t> ids();
    static constexpr std::uint64_t kNobody = std::numeric_limits<std::uint64_t>::max();
    /// What was found is of the particles before.
    void outdate();

private:
    /// The share of births with which no more live at once than there are places: those who come evenly are fewer,
    /// instead of none for a while.
    [[nodiscard]] float placesShare() const;
    /// The step at which a particle was born, or would have been where nothing was there to be born on.
    [[nodiscard]] std::int64_t birthStepOf(std::size_t slot) const;
    [[nodiscard]] float acts(float share) const;
    void retire();
    [[nodiscard]] std::int64_t countBirths(float share);
    /// Finds where births are on the parent's particles.
    void findBirths(std::int64_t births);
    void moveParticles(std::int64_t births);

    EmitterPose m_pose; ///< at the last step
    EmitterPose m_coming; ///< at the one that has begun
    EmitterPose m_reached; ///< at the end of the last call of the scene's step()
    EmitterPose m_target;
    glm::vec3 m_anchor; ///< where the emitter was at the start: turbulence stays where it is there
    float m_share = 1.0F;
    std::shared_ptr<SimulationModel> m_model; ///< made anew by setEffect() alone; its emitter moves in each step
    Frame m_frame;
    BirthClock m_clock;
    float m_acted = 0.0F; ///< share of the step after the last one for which the source acts on the air
    std::vector<StepConstants> m_parts; ///< of the last step
    std::int64_t m_first = 0; ///< birth index of the oldest that lives
    std::int64_t m_next = 0; ///< of the next that is born

    LiveLayer* m_parent = nullptr; ///< null: they are born on the emitter
    bool m_isParent = false;
    std::array<AlignedArray<float>, 3> m_before; ///< of a parent: places a step before
    std::vector<SubEmission> m_on; ///< of the births of a step, where there is a parent
    std::vector<std::size_t> m_ofAge; ///< of the parent: those of an age at which others are born on them
    std::vector<std::int32_t> m_birthSteps; ///< of a slot, where there is a parent: also of those that were not born
    std::int64_t m_absent = 0; ///< births from m_first on that had nothing to be born on

    bool m_appearanceIsNew = false;
    bool m_coloursAreNew = false;
    Appearance m_appearance;
    std::vector<glm::vec4> m_colours;
    std::vector<float> m_ages;
    std::vector<std::uint64_t> m_ids;
};

} // namespace fumage
