#include "core/lighting/particle_light.h"

#include <algorithm>

namespace fumage {

namespace {

Float4 colour4(const glm::vec3& colour)
{
    return Float4{colour.r, colour.g, colour.b, 0.0F};
}

} // namespace

ParticleLight particleLight(const Effect& effect, const LightGrid& grid)
{
    ParticleLight out;
    const std::array<glm::vec3, kColourTableSize> albedo = coloursOverLife(effect.look);
    std::transform(albedo.begin(), albedo.end(), out.albedo.begin(), colour4);
    out.hotCore = effect.glow.hotCore;
    out.glows = effect.glow.emission > 0.0F;
    if (out.glows) {
        const GlowColours colours = glowColours(effect.glow);
        out.glow = GlowTable(effect, colours);
        std::transform(colours.begin(), colours.end(), out.emission.begin(),
            [&](const glm::vec3& colour) { return colour4(colour * effect.glow.emission); });
    }
    out.sun = colour4(effect.light.colour);
    out.sky = colour4(effect.light.sky * effect.light.ambient);
    out.ground = colour4(effect.light.ground * effect.light.ambient);
    out.isScattered = !grid.diffuse.empty();
    out.isLitByFire = effect.glow.fireLight > 0.0F && !grid.fire.empty();
    out.fire = colour4(grid.fireColour * grid.fireStrength);
    return out;
}

} // namespace fumage
