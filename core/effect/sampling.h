#pragma once

#include "core/effect/effect.h"

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
        return sameParent && one.m_effect == other.m_effect;
    }

private:
    explicit SampledEffect(const Effect& effect)
        : m_effect(effect)
    {
    }
    friend SampledEffect sampled(const Effect& effect);
    friend SampledEffect thinned(const SampledEffect& effect, int most);

    Effect m_effect;
    std::shared_ptr<const SampledEffect> m_parent;
};

/// The layers of a scene that are simulated and drawn together, one or more; their surroundings (air, wind, light,
/// camera, timeline, output) are the same.
using SampledLayers = std::span<const SampledEffect>;

/// Works output.quality into the numbers and leaves it good: draft has a quarter of the particles, final eight times as
/// many (kMaxParticles at most), larger or smaller and denser or thinner so that the smoke covers as much and is as
/// dense. Shadows keep their resolution: thin threads are as dark as their cells are fine, and light must not change
/// with the quality. Half of what the number changes goes into the size and half into the opacity: finer detail with
/// less noise.
[[nodiscard]] SampledEffect sampled(const Effect& effect);
SampledEffect sampled(const SampledEffect& effect) = delete;

/// The same look with fewer particles, for previews: sizes grow so that the smoke covers as much.
/// @param most particles, 1 or more
[[nodiscard]] SampledEffect thinned(const SampledEffect& effect, int most);

} // namespace fumage
