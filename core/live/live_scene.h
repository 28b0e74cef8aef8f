#pragma once

#include "core/live/birth_budget.h"
#include "core/live/live_air.h"
#include "core/live/live_layer.h"
#include "core/live/live_light.h"
#include "core/live/live_options.h"
#include "core/scene/scene.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace fumage {

/// Smoke of several layers that steps with a game: one clock, one air that all sources feed, one light over all.
///
/// Steps are those of the scene, as long as its timeline says; a game's time is saved up until there is one. The
/// timeline's length, loop and prewarm have no meaning here: smoke begins with nothing and goes on, each layer at its
/// emitter.start. Without setScene(), setEmitter(), a share, mostParticles and a budget the particles of each layer are
/// those of SceneSimulator, to the bit; but what is born on more than kMaxKeptParents particles is born on those that
/// are played, and not on as many as good quality has. With them, the same calls in the same order give the same bits
/// on every machine and for any number of threads, unless there is a budget.
///
/// Layers have the numbers of the scene, from 0 to layers() - 1. A muted one is not stepped, feeds no air and has no
/// particles; but where others are born on it, it is stepped for them, and neither lit nor in frames(). The order of
/// layers changes no particle.
///
/// Positions never jump: whatever changes, living particles go on from where they are. Velocities of turbulence, rings
/// and vortex belong to the parameters and change with them. Turbulence stays in the world while an emitter moves;
/// vortex, rings and pull go with it. What is born on another layer is born on its particles as they are in the game.
///
/// Air is computed in each step on a grid of air.resolution (16 to 32 is for games), whose box goes with an emitter:
/// that of the layer of least seed among those that feed it. Smoke that is left behind is carried by the wind alone.
/// See LiveAir.
///
/// Not thread-safe, uses all threads inside. After the first few steps, step() allocates nothing.
class LiveScene {
public:
    /// @param scene in range
    /// @error OutOfRange: that of checkAir(), or an option; UnknownName, OutOfRange: that of checkParent(); TooLarge:
    /// more particles than kMaxParticles
    [[nodiscard]] static Result<LiveScene> start(const Scene& scene, const LiveOptions& options = {});

    /// Lets time pass.
    /// @param seconds 0 or more, of the game
    /// @return how many steps were made of it, 0 to mostStepsAtOnce
    /// @error OutOfRange where it is negative or no number; nothing has then happened
    /// O(particles) a step, and O(cells) of air.
    [[nodiscard]] Result<int> step(double seconds);

    /// Takes parameters from the next step on. Those of birth act on what is born from then on, all others on living
    /// particles too; lifetime as well: a shorter one ends those that have passed it. emitter.start means something
    /// until the layer has begun. An emitter goes where its layer says only where that has changed since the last time,
    /// as by setEmitter().
    /// @param wanted in range
    /// @error OutOfRange where it changes what is fixed: which layers there are, their names, what is muted and what is
    /// born on what; the length of a step; box, grid, ground and obstacle of the air. All then stays as it was.
    [[nodiscard]] Status setScene(const Scene& wanted);
    /// The same of one layer, and of the surroundings, which are those of all.
    /// @param layer below layers()
    /// Allocates only where particles begin to roll, or to be deformed.
    [[nodiscard]] Status setEffect(std::size_t layer, const Effect& wanted);

    /// Moves the emitter of a layer: it is there at the end of the next step(), and goes there in a straight line
    /// during it. What is born on the way leaves from where the emitter was at that time, within a step too where
    /// emitter.subframe is on. A layer that is born on another takes of it the normal, and the place that vortex, rings
    /// and pull go by.
    /// @param layer below layers()
    /// @error OutOfRange where the pose has no direction or is no number
    [[nodiscard]] Status setEmitter(std::size_t layer, const EmitterPose& pose);
    /// Puts the emitter of a layer somewhere at once; nothing is born on the way.
    /// @error as setEmitter()
    [[nodiscard]] Status placeEmitter(std::size_t layer, const EmitterPose& pose);
    /// Moves all emitters as if they were one body, as a torch that is carried along: that of the first layer goes to
    /// the pose, the others keep their places beside it as the scene has them, see carriedAlong().
    /// @error as setEmitter(); none has then moved
    [[nodiscard]] Status setEmitters(const EmitterPose& pose);
    /// The same at once.
    [[nodiscard]] Status placeEmitters(const EmitterPose& pose);

    /// Sets the share of births that are born in all layers, 0 to 1 (clamped; 0 is a switch): beside the budget's, and
    /// other than that the same in every run.
    void setShare(float share) { m_share = share > 0.0F ? std::min(share, 1.0F) : 0.0F; }
    /// The same of one layer, beside that of all.
    void setShare(std::size_t layer, float share) { m_layers[layer].setShare(share); }
    /// Effects of bursts burst again, or for the first time where they were none before.
    void burst();
    void burst(std::size_t layer) { m_layers[layer].burst(); }

    /// The scene as it was set.
    [[nodiscard]] const Scene& scene() const { return m_scene; }
    /// How many layers it has, muted ones too.
    [[nodiscard]] std::size_t layers() const { return m_layers.size(); }
    /// Whether a layer is to be drawn: it is not muted.
    [[nodiscard]] bool isVisible(std::size_t layer) const { return m_scene.layers[layer].visible; }
    /// Where the emitter of a layer is or is going.
    [[nodiscard]] const EmitterPose& emitter(std::size_t layer) const { return m_layers[layer].target(); }
    /// The share of a layer's births now: of both setShare(), and of what the budget and the places leave.
    [[nodiscard]] float share(std::size_t layer) const;
    /// Whether the budget cannot be kept by thinning births: the air alone takes too long, or a few particles do.
    /// Coarser air or a larger budget would help.
    [[nodiscard]] bool isOverBudget() const { return m_budget && m_budget->isHopeless(); }
    /// Seconds a step.
    [[nodiscard]] double stepSeconds() const { return m_stepSeconds; }
    /// Time that is saved up and no step yet: how far the particles are behind the game, s.
    [[nodiscard]] double saved() const { return m_saved; }

    /// Columns of all particles of a layer, one slot each; slots that nobody lives in have kUnborn as birthStep. They
    /// stay where they are until setScene() or setEffect().
    [[nodiscard]] const Particles& particles(std::size_t layer) const { return m_layers[layer].particles(); }
    /// Particles of a layer that have been born and not died.
    [[nodiscard]] std::size_t living(std::size_t layer) const { return m_layers[layer].living(); }
    /// The same of all layers, muted ones that others are born on, too.
    [[nodiscard]] std::size_t living() const;
    /// Radius and opacity of each slot, 0 where nobody lives, as the renderer has them. Found on the first call after a
    /// step.
    [[nodiscard]] const Appearance& appearance(std::size_t layer) { return m_layers[layer].appearance(); }
    /// Colour of each slot before light, linear, and its opacity: look.colour and its gradient, and appearance().alpha.
    [[nodiscard]] std::span<const glm::vec4> colours(std::size_t layer) { return m_layers[layer].colours(); }
    /// Colour of each slot in the light of the whole scene, linear, not multiplied by the opacity, which is the fourth
    /// number and that of colours(): sun through the shadow of all layers, sky, ground, the fire of all, and what the
    /// particle glows itself, which may be more than 1. 0 where nobody is seen; empty of a muted layer. The same as
    /// direct + ambient of the sprites that Renderer::prepare() makes of frames(), to the bit; but look.texture, which
    /// only sprites have, throws no other shadow here. Light is found on the first call after a step, for all layers,
    /// and again for another eye.
    /// @param eye the camera, m: towards the sun smoke is brighter, by light.anisotropy; none: from everywhere the same
    /// @error OutOfRange where the eye, or a particle, is nowhere
    /// O(particles + cells of light.resolution), several times a step's time; see resources/docs/games.md. Allocates
    /// nothing but where the smoke needs a larger grid than any before.
    [[nodiscard]] Result<std::span<const glm::vec4>> litColours(
        std::size_t layer, const std::optional<glm::vec3>& eye = std::nullopt);
    /// Way out of the smoke of all layers at each slot, of length 1: against the gradient of its density. 0 where
    /// nobody is seen, and where no way leads out: all around is as dense, or nothing throws shadow. Found on the first
    /// call after a step.
    /// @error OutOfRange where a particle is nowhere
    /// After litColours() a fraction of its cost, else as much.
    [[nodiscard]] Result<std::span<const glm::vec3>> normals(std::size_t layer);
    /// Seconds since the birth of each slot's particle, 0 where nobody lives. Found on the first call after a step.
    [[nodiscard]] std::span<const float> ages(std::size_t layer) { return m_layers[layer].ages(); }
    /// The number of each slot's particle, counted from the first that was born in its layer: it stays a particle's own
    /// as long as it lives, and is never given again. kNobody where nobody lives. Found on the first call after a step.
    [[nodiscard]] std::span<const std::uint64_t> ids(std::size_t layer) { return m_layers[layer].ids(); }
    static constexpr std::uint64_t kNobody = LiveLayer::kNobody;
    /// The frame of a layer; changed by the next step. Its step is counted from emitter.start, and below 0 before that.
    [[nodiscard]] const Frame& frame(std::size_t layer) const { return m_layers[layer].frame(); }
    /// The effect that frame() was made of: with its quality worked in, and the emitter where it is.
    [[nodiscard]] const SampledEffect& sampledEffect(std::size_t layer) const { return m_layers[layer].effect(); }
    /// What Renderer::render() takes: the layers that are not muted, in their order. Stays valid as long as the scene
    /// stays where it is.
    [[nodiscard]] LayerFrames frames() const { return m_frames; }

private:
    LiveScene(const Scene& scene, const LiveOptions& options);

    /// Makes everything that may fail at the start.
    [[nodiscard]] Status begin();
    /// Which layers are stepped, those that others are born on before these.
    void findOrder();
    [[nodiscard]] Status makeRoom();
    /// Makes what is visible of the scene as it is set.
    void sampleVisible();
    /// Gives all layers what the scene says.
    void setEffects();
    /// Sends an emitter where a changed effect says.
    void followEmitter(std::size_t layer, const Emitter& before, const Emitter& now);
    /// Whether anything changes over time by key frames.
    [[nodiscard]] bool hasTracks() const;
    /// Sets what key frames say of the step to come, and sends emitters along their ways; where they jump they are
    /// there at once.
    void animate();
    /// What of an emitter has key frames that say where it is at the end of each step.
    [[nodiscard]] LiveLayer::KeyedPose keyedPose(std::size_t layer) const;
    /// The same of the obstacle.
    [[nodiscard]] bool obstacleGoesByKeys() const;
    /// @param share of the way that what the game moves has gone by then since the last call of step(), 0 to 1
    void stepOnce(double share);
    void stepAir(double share);
    void outdateLight();
    [[nodiscard]] LiveLight& light();

    Scene m_scene; ///< as it was set
    LiveOptions m_options;
    double m_stepSeconds;
    double m_saved = 0.0;
    std::int64_t m_step = -1; ///< the last one
    float m_share = 1.0F;
    std::vector<LiveLayer> m_layers; ///< all of the scene
    std::vector<std::size_t> m_order; ///< those that are stepped, a parent before its children
    std::vector<SampledEffect> m_sampled; ///< of those that are visible, where their emitters are at the start
    std::vector<std::size_t> m_visible; ///< their numbers
    std::vector<std::size_t> m_feeding; ///< their places in m_visible, see findFeedingLayers()
    std::vector<AirFeeder> m_feeders; ///< of the last step
    std::unique_ptr<LiveAir> m_air; ///< null: none carries the smoke
    std::optional<BirthBudget> m_budget;
    std::vector<LayerFrame> m_frames;
    std::unique_ptr<LiveLight> m_light; ///< null: nobody has asked for it
};

} // namespace fumage
