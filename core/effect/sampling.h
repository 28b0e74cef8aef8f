#pragma once

#include "core/effect/tracks.h"

#include <memory>
#include <span>

namespace fumage {

/// An effect with its output.quality worked into its numbers. Only sampled() and thinned() make one, and what simulates
/// and draws takes nothing else: no numbers of the document reach a picture without their quality, and none with it
/// twice.
class SampledEffect {
public:
    /// The defaults, whose quality is good.
    SampledEffect() = default;

    [[nodiscard]] const Effect* operator->() const { return &m_effect; }
    [[nodiscard]] operator const Effect&() const
    {
        return m_effect;
    } // NOLINT(google-explicit-constructor): whatever reads an effect reads this one

    /// The layer on whose particles those of this one are born, as it is at good quality whatever is asked for; null:
    /// they are born on the emitter.
    [[nodiscard]] const std::shared_ptr<const SampledEffect>& parent() const { return m_parent; }
    void setParent(std::shared_ptr<const SampledEffect> parent) { m_parent = std::move(parent); }

    /// What changes over time: tracks of the layer and of what all layers share, none of them constant; null: nothing
    /// does. The values that they stand for are read by atFrame() and atTime().
    [[nodiscard]] const std::shared_ptr<const Tracks>& tracks() const { return m_tracks; }
    /// Whether anything changes over time that is read in one way.
    [[nodiscard]] bool isAnimated(Animates when) const { return m_tracks && m_tracks->any(when); }

    /// How one parameter changes over time; null: it does not.
    [[nodiscard]] const Track* track(const Parameter& row) const { return m_tracks ? m_tracks->find(row) : nullptr; }
    [[nodiscard]] bool changes(const Parameter& row) const { return track(row) != nullptr; }
    /// All of tracks(); none where nothing changes.
    [[nodiscard]] std::span<const Track> allTracks() const
    {
        return m_tracks ? m_tracks->all() : std::span<const Track>();
    }

    /// The effect as a frame is drawn: parameters that are read once a frame have their values, and the turntable has
    /// turned. Of what changes over time it has only what is a rate of each particle's own, as its spin: that is summed
    /// up over the particle's life.
    /// @param number 0 or more; in a loop, frames that lie a whole loop apart are alike
    [[nodiscard]] SampledEffect atFrame(int number) const;
    /// The effect as particles move and are born: all parameters that are read at a step, at a birth, or as a rate,
    /// have their values; the rest is as it is without key frames.
    /// @param seconds since frame 0
    [[nodiscard]] SampledEffect atTime(double seconds) const;

    /// The effect with each number that changes over time at its greatest key: for what may not change while it does,
    /// as how often swirls become others, and for room.
    [[nodiscard]] SampledEffect strongest() const;

    /// Puts the emitter elsewhere, and turns it: that is the same for every quality.
    void placeEmitter(const glm::vec3& position, const glm::vec3& normal)
    {
        m_effect.emitter.position = position;
        m_effect.emitter.normal = normal;
    }

    friend bool operator==(const SampledEffect& one, const SampledEffect& other)
    {
        const bool sameParent =
            one.m_parent && other.m_parent ? *one.m_parent == *other.m_parent : one.m_parent == other.m_parent;
        const bool sameTracks =
            one.m_tracks && other.m_tracks ? *one.m_tracks == *other.m_tracks : one.m_tracks == other.m_tracks;
        return sameParent && sameTracks && one.m_effect == other.m_effect && one.m_sizeFactor == other.m_sizeFactor
            && one.m_opacityFactor == other.m_opacityFactor;
    }

private:
    explicit SampledEffect(const Effect& effect)
        : m_effect(effect)
    {
    }
    friend SampledEffect sampled(const Effect& effect, const Tracks& tracks);
    friend SampledEffect thinned(const SampledEffect& effect, int most);
    void scaleLook(float size, float opacity);

    Effect m_effect;
    std::shared_ptr<const Tracks> m_tracks;
    std::shared_ptr<const Tracks> m_ownRates; ///< those of m_tracks that are rates of each particle's own; null: none
    float m_sizeFactor = 1.0F; ///< what the quality has made of sizes, and of opacities
    float m_opacityFactor = 1.0F;
    std::shared_ptr<const SampledEffect> m_parent;
};

/// The time of a frame since frame 0, s; in a loop within its length.
/// @param number 0 or more
[[nodiscard]] double secondsOfFrame(const Timeline& timeline, int number);
/// How long a timeline is, s: where its last frame ends.
[[nodiscard]] double lengthInSeconds(const Timeline& timeline);

/// Writes into an effect what is read once a frame, and how far the turntable has turned.
/// @param number 0 or more
void readFrame(const Tracks& tracks, int number, Effect& effect);

/// The layers of a scene that are simulated and drawn together, one or more; their surroundings (air, wind, light,
/// camera, timeline, output) are the same.
using SampledLayers = std::span<const SampledEffect>;

/// Works output.quality into the numbers and leaves it good: draft has a quarter of the particles, final eight times as
/// many (kMaxParticles at most), larger or smaller and denser or thinner so that the smoke covers as much and is as
/// dense. Shadows keep their resolution: thin threads are as dark as their cells are fine, and light must not change
/// with the quality. Half of what the number changes goes into the size and half into the opacity: finer detail with
/// less noise.
/// @param tracks what changes over time; constant tracks count as the value that they have
[[nodiscard]] SampledEffect sampled(const Effect& effect, const Tracks& tracks = {});
SampledEffect sampled(const SampledEffect& effect) = delete;

/// The same look with fewer particles, for previews: sizes grow so that the smoke covers as much.
/// @param most particles, 1 or more
[[nodiscard]] SampledEffect thinned(const SampledEffect& effect, int most);

} // namespace fumage
