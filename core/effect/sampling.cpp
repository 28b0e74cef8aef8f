#include "core/effect/sampling.h"

#include "core/effect/known_parameter.h"
#include "core/effect/value.h"

#include <algorithm>
#include <cmath>

namespace fumage {

SampledEffect sampled(const Effect& effect)
{
    Effect out = effect;
    out.output.quality = Quality::Good;
    if (effect.output.quality == Quality::Good) {
        return SampledEffect(out);
    }
    const bool fine = effect.output.quality == Quality::Final;
    constexpr int kFiner = 8;
    constexpr int kCoarser = 4;
    const int count = effect.emitter.count;
    out.emitter.count =
        fine ? (count > kMaxParticles / kFiner ? kMaxParticles : count * kFiner) : std::max(1, count / kCoarser);
    // What makes smoke dense is count * size^2 * opacity.
    const float ratio = static_cast<float>(count) / static_cast<float>(out.emitter.count);
    const float root = std::sqrt(ratio);
    setClamped(out, knownParameter("look.size"), effect.look.size * std::sqrt(root));
    setClamped(out, knownParameter("look.opacity"), effect.look.opacity * root);
    return SampledEffect(out);
}

SampledEffect thinned(const SampledEffect& effect, int most)
{
    SampledEffect fewer = effect;
    Effect& out = fewer.m_effect;
    if (out.emitter.count > most) {
        // What covers the picture is count * size^2.
        const float ratio = static_cast<float>(out.emitter.count) / static_cast<float>(most);
        out.emitter.count = most;
        setClamped(out, knownParameter("look.size"), out.look.size * std::sqrt(ratio));
    }
    return fewer;
}

} // namespace fumage
