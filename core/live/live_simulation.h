#pragma once

#include "core/live/live_scene.h"

#include <optional>
#include <span>

namespace fumage {

/// Smoke of one effect that steps with a game: a LiveScene of one layer.
///
/// Steps are those of the effect, as long as timeline says; a game's time is saved up until there is one. The
/// timeline's length, loop and prewarm have no meaning here: smoke begins with nothing and goes on. Without
/// setEffect(), setEmitter() and a budget the particles are those of Simulator, to the bit (they begin at
/// emitter.start); with them, the same calls in the same order give the same bits on every machine and for any number
/// of threads, unless there is a budget.
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
    [[nodiscard]] Result<int> step(double seconds) { return m_scene.step(seconds); }

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
    [[nodiscard]] Status setEmitter(const EmitterPose& pose) { return m_scene.setEmitter(0, pose); }

    /// Puts the emitter somewhere at once; nothing is born on the way.
    /// @error as setEmitter()
    [[nodiscard]] Status placeEmitter(const EmitterPose& pose) { return m_scene.placeEmitter(0, pose); }

    /// Sets the share of births that are born, 0 to 1 (clamped; 0 is a switch): beside the budget's, and other than
    /// that the same in every run.
    void setShare(float share) { m_scene.setShare(share); }

    /// An effect of bursts bursts again, or for the first time where it was none before.
    void burst() { m_scene.burst(); }

    /// The effect as it was set.
    [[nodiscard]] const Effect& effect() const { return m_effect; }
    /// Where the emitter is or is going.
    [[nodiscard]] const EmitterPose& emitter() const { return m_scene.emitter(0); }
    /// The share of births now: of setShare(), and of what the budget and the places leave.
    [[nodiscard]] float share() const { return m_scene.share(0); }
    /// Whether the budget cannot be kept by thinning births: the air alone takes too long, or a few particles do.
    /// Coarser air or a larger budget would help.
    [[nodiscard]] bool isOverBudget() const { return m_scene.isOverBudget(); }
    /// Seconds a step.
    [[nodiscard]] double stepSeconds() const { return m_scene.stepSeconds(); }
    /// Time that is saved up and no step yet: how far the particles are behind the game, s.
    [[nodiscard]] double saved() const { return m_scene.saved(); }

    /// Columns of all particles, one slot each; slots that nobody lives in have kUnborn as birthStep. They stay where
    /// they are until setEffect().
    [[nodiscard]] const Particles& particles() const { return m_scene.particles(0); }
    /// Particles that have been born and not died.
    [[nodiscard]] std::size_t living() const { return m_scene.living(); }
    /// Radius and opacity of each slot, 0 where nobody lives, as the renderer has them. Found on the first call after a
    /// step.
    [[nodiscard]] const Appearance& appearance() { return m_scene.appearance(0); }
    /// Colour of each slot before light, linear, and its opacity: look.colour and its gradient, and appearance().alpha.
    [[nodiscard]] std::span<const glm::vec4> colours() { return m_scene.colours(0); }
    /// Colour of each slot in its light, linear, not multiplied by the opacity, which is the fourth number and that of
    /// colours(): sun through the smoke's own shadow, sky, ground, fire, and what the particle glows itself, which may
    /// be more than 1. 0 where nobody is seen. The same as direct + ambient of the sprites that
    /// Renderer::prepare() makes of frame(), to the bit; but look.texture, which only sprites have, throws no other
    /// shadow here. Found on the first call after a step, and again for another eye.
    /// @param eye the camera, m: towards the sun smoke is brighter, by light.anisotropy; none: from everywhere the same
    /// @error OutOfRange where the eye, or a particle, is nowhere
    /// O(particles + cells of light.resolution), several times a step's time; see resources/docs/games.md. Allocates
    /// nothing but where the smoke needs a larger grid than any before.
    [[nodiscard]] Result<std::span<const glm::vec4>> litColours(const std::optional<glm::vec3>& eye = std::nullopt)
    {
        return m_scene.litColours(0, eye);
    }
    /// Way out of the smoke at each slot, of length 1: against the gradient of its density. 0 where nobody is seen, and
    /// where no way leads out: all around is as dense, or nothing throws shadow. Found on the first call after a step.
    /// @error OutOfRange where a particle is nowhere
    /// After litColours() a fraction of its cost, else as much.
    [[nodiscard]] Result<std::span<const glm::vec3>> normals() { return m_scene.normals(0); }
    /// Seconds since the birth of each slot's particle, 0 where nobody lives. Found on the first call after a step.
    [[nodiscard]] std::span<const float> ages() { return m_scene.ages(0); }
    /// The number of each slot's particle, counted from the first that was born: it stays a particle's own as long as
    /// it lives, and is never given again. kNobody where nobody lives. Found on the first call after a step.
    [[nodiscard]] std::span<const std::uint64_t> ids() { return m_scene.ids(0); }
    static constexpr std::uint64_t kNobody = LiveScene::kNobody;
    /// What Renderer::render() takes, together with sampledEffect(); changed by the next step.
    [[nodiscard]] const Frame& frame() const { return m_scene.frame(0); }
    /// The effect that frame() was made of: with its quality worked in, and the emitter where it is.
    [[nodiscard]] const SampledEffect& sampledEffect() const { return m_scene.sampledEffect(0); }

private:
    explicit LiveSimulation(LiveScene scene);

    LiveScene m_scene;
    Effect m_effect; ///< as it was set
};

} // namespace fumage
