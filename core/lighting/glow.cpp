#include "core/lighting/glow.h"

#include "core/base/math.h"
#include "core/lighting/black_body.h"

#include <algorithm>
#include <cmath>

namespace fumage {

namespace {

float brightest(const glm::vec3& colour)
{
    return std::max({colour.r, colour.g, colour.b});
}

} // namespace

GlowColours glowColours(const Glow& glow)
{
    const BlackBody body(glow.temperature);
    GlowColours colours;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(colours.size() - 1);
        colours[i] = glow.emissionColour == EmissionColour::BlackBody ? body.at(glow.temperature * share)
                                                                      : glow.emissionGradient.at(share);
    }
    return colours;
}

GlowTable::GlowTable(const Effect& effect, const GlowColours& colours)
    : heatVariance(effect.motion.heatVariance)
    , cooling(effect.glow.emissionCooling)
    , clears(hasClearFlames(effect.glow))
{
    opaque.fill(1.0F);
    if (!clears) {
        return;
    }
    float most = 1e-12F; // black everywhere glows nowhere
    for (const glm::vec3& colour : colours) {
        most = std::max(most, brightest(colour));
    }
    // A quarter of the brightest is a flame yet; the root brings what is dim nearer to the eye.
    constexpr float kFlame = 0.25F;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const float t = std::min(1.0F, std::sqrt(brightest(colours[i]) / (kFlame * most)));
        opaque[i] = 1.0F - (1.0F - effect.glow.flameOpacity) * smoothStep(t);
    }
}

} // namespace fumage
