#pragma once

#include "core/base/result.h"
#include "core/lighting/appearance.h"
#include "core/live/birth_budget.h"
#include "core/live/birth_clock.h"
#include "core/live/emitter_pose.h"
#include "core/live/live_air.h"
#include "core/live/live_light.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace fumage {

/// What is fixed when a simulation starts.
struct LiveOptions {
    /// In place of the effect's, 1 to 240, best as many as the game has; 0: those of the effect
    int stepsPerSecond = 0;
    int mostParticles = 0; ///< alive at once, up to kMaxParticles; memory is taken for all of them, and births are
                           ///< thinned so that they suffice. 0: as many as the effect has at the start
    /// Milliseconds that a step of the simulation may take, kept by thinning births; 0: none. With one, two runs differ
    double budgetMs = 0.0;
    int mostStepsAtOnce = 8; ///< in one call of step(), 1 or more: time beyond it is let go, so that a game that has
                             ///< stood still does not race
    std::function<double()> clock{}; ///< that the budget is measured with, s from any start on, asked three times a
                                     ///< step; empty: the machine's. Throws nothing
};

/// Smoke that steps with a game.
///
/// Steps are those of the effect, as long as timeline says; a game's time is saved up until there is one. The
/// timeline's length, loop and prewarm have no meaning here: smoke begins with nothing and goes on. Without
/// setEffect(), setEmitter() and a budget the particles are those of Simulator, to the bit; with them, the same calls
/// in the same order give the same bits on every machine and for any number of threads, unless there is a budget.
///
/// Positions never jump: whatever changes, living particles go on from where they are. Velocities of turbulence, rings
/// and vortex belong to the parameters and change with them. Turbulence stays in the world while the emitter moves;
/// vortex, rings and pull go with the emitter.
///
/// Air is computed in each step on a grid of the effect's air.resolution (16 to 32 is for games), whose box goes with
/// the emitter: smoke that is left behind is carried by the wind alone. See LiveAir.
///
/// Not thread-safe, uses all threads inside. After the first few steps, step() allocates nothing.
class LiveSimulation {
public:
    /// @param effect in range
    /// @error OutOfRange: that of checkAir(), or an option; TooLarge: more particles than kMaxParticles
    [[nodiscard]] static Result<LiveSimulation> start(const Effect& effect, const LiveOptions& options = {});

    /// Lets time pass.
    /// @param seconds 0 or more, of the game
    /// @return how many steps were made of it, 0 to mostStepsAtOnce
    /// @error OutOfRange where it is negative or no number; nothing has then happened
    /// O(particles) a step, and O(cells) of air.
    [[nodiscard]] Result<int> step(double seconds);

    /// Takes parameters from the next step on. Those of birth act on what is born from then on, all others on living
    /// particles too; lifetime as well: a shorter one ends those that have passed it. The emitter goes where the effect
    /// says only where that has changed since the last effect, as by setEmitter().
    /// @param wanted in range
    /// @error OutOfRange where it changes what is fixed: the length of a step, and box, grid, ground and obstacle of
    /// the air. The effect then stays as it was Allocates only where particles begin to roll, or to be deformed.
    [[nodiscard]] Status setEffect(const Effect& wanted);

    /// Moves the emitter: it is there at the end of the next step(), and goes there in a straight line during it. What
    /// is born on the way leaves from where the emitter was at that time, within a step too where emitter.subframe is
    /// on.
    /// @error OutOfRange where the pose has no direction or is no number
    [[nodiscard]] Status setEmitter(const EmitterPose& pose);

    /// Puts the emitter somewhere at once; nothing is born on the way.
    /// @error as setEmitter()
    [[nodiscard]] Status placeEmitter(const EmitterPose& pose);

    /// Sets the share of births that are born, 0 to 1 (clamped; 0 is a switch): beside the budget's, and other than
    /// that the same in every run.
    void setShare(float share);

    /// An effect of bursts bursts again, or for the first time where it was none before.
    void burst() { m_clock.restart(); }

    /// The effect as it was set.
    [[nodiscard]] const Effect& effect() const { return m_effect; }
    /// Where the emitter is or is going.
    [[nodiscard]] const EmitterPose& emitter() const { return m_target; }
    /// The share of births now: of setShare(), and of what the budget and the places leave.
    [[nodiscard]] float share() const;
    /// Whether the budget cannot be kept by thinning births: the air alone takes too long, or a few particles do.
    /// Coarser air or a larger budget would help.
    [[nodiscard]] bool isOverBudget() const { return m_budget && m_budget->isHopeless(); }
    /// Seconds a step.
    [[nodiscard]] double stepSeconds() const { return m_stepSeconds; }
    /// Time that is saved up and no step yet: how far the particles are behind the game, s.
    [[nodiscard]] double saved() const { return m_saved; }

    /// Columns of all particles, one slot each; slots that nobody lives in have kUnborn as birthStep. They stay where
    /// they are until setEffect().
    [[nodiscard]] const Particles& particles() const { return m_frame.particles; }
    /// Particles that have been born and not died.
    [[nodiscard]] std::size_t living() const { return static_cast<std::size_t>(m_next - m_first); }
    /// Radius and opacity of each slot, 0 where nobody lives, as the renderer has them. Found on the first call after a
    /// step.
    [[nodiscard]] const Appearance& appearance();
    /// Colour of each slot before light, linear, and its opacity: look.colour and its gradient, and appearance().alpha.
    [[nodiscard]] std::span<const glm::vec4> colours();
    /// Colour of each slot in its light, linear, not multiplied by the opacity, which is the fourth number and that of
    /// colours(): sun through the smoke's own shadow, sky, ground, fire, and what the particle glows itself, which may
    /// be more than 1. 0 where nobody is seen. The same as direct + ambient of the sprites that
    /// Renderer::prepare() makes of frame(), to the bit; but look.texture, which only sprites have, throws no other
    /// shadow here. Found on the first call after a step, and again for another eye.
    /// @param eye the camera, m: towards the sun smoke is brighter, by light.anisotropy; none: from everywhere the same
    /// @error OutOfRange where the eye, or a particle, is nowhere
    /// O(particles + cells of light.resolution), several times a step's time; see resources/docs/games.md. Allocates
    /// nothing but where the smoke needs a larger grid than any before.
    [[nodiscard]] Result<std::span<const glm::vec4>> litColours(const std::optional<glm::vec3>& eye = std::nullopt);
    /// Way out of the smoke at each slot, of length 1: against the gradient of its density. 0 where nobody is seen, and
    /// where no way leads out: all around is as dense, or nothing throws shadow. Found on the first call after a step.
    /// @error OutOfRange where a particle is nowhere
    /// After litColours() a fraction of its cost, else as much.
    [[nodiscard]] Result<std::span<const glm::vec3>> normals();
    /// Seconds since the birth of each slot's particle, 0 where nobody lives. Found on the first call after a step.
    [[nodiscard]] std::span<const float> ages();
    /// The number of each slot's particle, counted from the first that was born: it stays a particle's own as long as
    /// it lives, and is never given again. kNobody where nobody lives. Found on the first call after a step.
    [[nodiscard]] std::span<const std::uint64_t> ids();
    static constexpr std::uint64_t kNobody = std::numeric_limits<std::uint64_t>::max();
    /// What Renderer::render() takes, together with sampledEffect(); changed by the next step.
    [[nodiscard]] const Frame& frame() const { return m_frame; }
    /// The effect that frame() was made of: with its quality worked in, and the emitter where it is.
    [[nodiscard]] const SampledEffect& sampledEffect() const { return m_model->effect(); }

private:
    LiveSimulation(const Effect& effect, const LiveOptions& options);

    /// Of the effect as it is set, with the emitter where it is.
    [[nodiscard]] SimulationModel makeModel() const;
    void stepOnce(const EmitterPose& pose);
    void retire(std::int64_t step);
    [[nodiscard]] std::int64_t countBirths();
    /// The share of births with which no more live at once than there are places: those who come evenly are fewer,
    /// instead of none for a while.
    [[nodiscard]] float placesShare() const;
    void moveParticles(const EmitterPose& pose, std::int64_t births);
    /// What was found of the particles is of those before.
    void outdate();
    [[nodiscard]] LiveLight& light();

    Effect m_effect; ///< as it was set
    LiveOptions m_options;
    double m_stepSeconds;
    double m_saved = 0.0;
    EmitterPose m_pose; ///< at the last step
    EmitterPose m_reached; ///< at the end of the last step()
    EmitterPose m_target;
    glm::vec3 m_anchor; ///< where the emitter was at the start: turbulence stays where it is there
    std::unique_ptr<LiveAir> m_air; ///< null: none carries the smoke
    std::shared_ptr<SimulationModel> m_model; ///< made anew by setEffect() alone; its emitter moves in each step
    Frame m_frame;
    BirthClock m_clock;
    float m_acted = 0.0F; ///< share of the step after the last one for which the source acts on the air
    std::vector<StepConstants> m_parts; ///< of the last step
    std::optional<BirthBudget> m_budget;
    float m_share = 1.0F;
    std::int64_t m_first = 0; ///< birth index of the oldest that lives
    std::int64_t m_next = 0; ///< of the next that is born
    bool m_appearanceIsNew = false;
    bool m_coloursAreNew = false;
    Appearance m_appearance;
    std::vector<glm::vec4> m_colours;
    std::unique_ptr<LiveLight> m_light; ///< null: nobody has asked for it
    std::vector<float> m_ages;
    std::vector<std::uint64_t> m_ids;
};

} // namespace fumage
