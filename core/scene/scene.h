#pragma once

#include "core/base/result.h"
#include "core/effect/effect.h"
#include "core/effect/sampling.h"
#include "core/effect/tracks.h"
#include "core/scene/marker.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fumage {

/// Most layers of a scene.
inline constexpr std::size_t kMaxLayers = 64;

/// Most bytes of a layer's name.
inline constexpr std::size_t kMaxLayerName = 256;

/// What tells layers apart in a list; none has no colour.
enum class ColourTag {
    None,
    Red,
    Orange,
    Yellow,
    Green,
    Blue,
    Violet,
    Grey
};

/// One emitter of a scene, with all that its particles are: plain data, as in an Effect.
struct Layer {
    std::string name; ///< UTF-8; may be empty
    bool visible = true; ///< else it is neither simulated nor drawn, and does not feed the air; in exports, too
    bool locked = false; ///< against changes in the editor
    ColourTag tag = ColourTag::None;
    /// The name of the layer on whose particles its own are born, its parent; empty: on its emitter. Such a layer feeds
    /// no air. The parent need not be visible.
    std::string from;
    Emitter emitter;
    Source source;
    Motion motion;
    Turbulence turbulence;
    Vortex vortex;
    Rings rings;
    Life life;
    Look look;
    Noise noise;
    Glow glow;
    Tracks tracks; ///< of its own parameters
    friend bool operator==(const Layer&, const Layer&) = default;
};

/// Everything that decides what a picture looks like: the surroundings, of which there is one each, and the layers that
/// lie in them. A frame is a pure function of it and the frame number.
///
/// An Effect is a layer seen in its surroundings: what simulates, lights and draws one layer takes that.
struct Scene {
    Wind wind;
    Air air;
    Light light;
    Camera camera;
    Timeline timeline;
    Output output;
    Tracks tracks; ///< of the surroundings' parameters
    std::vector<Marker> markers; ///< in the order of their times, as checkMarkers() has them; they change no picture
    std::vector<Layer> layers{Layer()}; ///< 1 to kMaxLayers

    Scene() = default;
    Scene(const Effect& effect); // NOLINT(google-explicit-constructor): an effect is a scene of one layer

    /// A layer in its surroundings.
    /// @param layer below layers.size()
    [[nodiscard]] Effect effect(std::size_t layer = 0) const;
    /// The same with the values that all parameters have at a time which change over time, whenever they are read: what
    /// somebody looks at, or what is set from outside step by step.
    /// @param seconds since frame 0
    [[nodiscard]] Effect effectAt(std::size_t layer, double seconds) const;
    /// Takes an effect apart: the surroundings become its own, and the layer.
    void assign(std::size_t layer, const Effect& effect);
    /// Takes the surroundings alone.
    void setSurroundings(const Effect& effect);
    /// The tracks that a parameter of a layer has its own in: the layer's, or those of what all layers share.
    [[nodiscard]] Tracks& tracksOf(const Parameter& parameter, std::size_t layer);
    [[nodiscard]] const Tracks& tracksOf(const Parameter& parameter, std::size_t layer) const;
    /// All that changes over time of a layer in its surroundings.
    [[nodiscard]] Tracks allTracks(std::size_t layer) const;
    /// The scene as a frame is drawn, for what looks at it, without key frames: what is read once a frame has its
    /// value, what is read at steps and births is as it is without.
    /// @param number 0 or more
    [[nodiscard]] Scene atFrame(int number) const;
    /// The layers that are seen, in their order; where none is, none.
    [[nodiscard]] std::vector<std::size_t> visibleLayers() const;
    /// Particles of all layers that are seen, once they are warm.
    [[nodiscard]] std::int64_t particles() const;

    friend bool operator==(const Scene&, const Scene&) = default;
};

/// Index of the layer that a name or a number (from 1) stands for; none: there is none, or several have the name.
[[nodiscard]] std::optional<std::size_t> findLayer(const Scene& scene, std::string_view nameOrNumber);

/// The layer on whose particles those of another are born; none: on its emitter, or there is no such layer.
[[nodiscard]] std::optional<std::size_t> parentOf(const Scene& scene, std::size_t layer);

/// Whether a layer is another, or is born on one that is, or on one that is born on that, and so on.
[[nodiscard]] bool isBornOn(const Scene& scene, std::size_t layer, std::size_t ancestor);

/// Whether the parent of a layer is there and leads back to no layer that was on the way.
/// @error UnknownName where no layer, or several, have the name; OutOfRange where layers are born on one another in a
/// ring
[[nodiscard]] Status checkParent(const Scene& scene, std::size_t layer);

/// Lets layers whose parent checkParent() refuses be born on their emitters: after layers have gone or changed names.
void dropBrokenParents(Scene& scene);

/// Particles of all layers.
[[nodiscard]] std::int64_t particlesOf(SampledLayers layers);

/// Thins layers to a number of particles in all, where they have more: each gives up the same share, and keeps one. Few
/// that others are born on stay all, since they are known one by one.
/// @param most of all layers, 1 or more
void thinLayers(std::vector<SampledEffect>& layers, std::int64_t most);

/// Most particles of a layer that others are born on that no quality and no preview changes.
inline constexpr int kMaxKeptParents = 4096;

/// A layer in its surroundings as it is simulated, before its quality is worked in: what is born on another has no
/// source in the air, and what others are born on has good quality where it has few particles or is not seen.
[[nodiscard]] Effect simulatedEffect(const Scene& scene, std::size_t layer);

/// The visible layers of a scene as they are simulated and drawn, with the quality worked into their numbers, and with
/// kMaxParticles in all at most. Where none is visible it is the first one, transparent: a picture has a camera. A
/// parent that is not there, or a ring of them, counts as none; see checkParent().
[[nodiscard]] std::vector<SampledEffect> sampledLayers(const Scene& scene);

/// One layer of them, whether it is visible or not, without the bound on all layers together.
[[nodiscard]] SampledEffect sampledLayer(const Scene& scene, std::size_t layer);

} // namespace fumage
