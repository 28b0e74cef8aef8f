#pragma once

#include "tests/helpers.h"

#include "core/effect/sampling.h"
#include "core/lighting/appearance.h"
#include "core/lighting/light_grid.h"

namespace fumage::tests {

/// A frame with particles of one mass at chosen places; ages and lives are those of newborns.
inline Frame cloud(const Effect& effect, const std::vector<glm::vec3>& places)
{
    Frame frame;
    frame.model = std::make_shared<const SimulationModel>(sampled(effect));
    frame.step = 0;
    frame.particles.reset(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        frame.particles.x[i] = places[i].x;
        frame.particles.y[i] = places[i].y;
        frame.particles.z[i] = places[i].z;
        frame.particles.birthStep[i] = 0;
        frame.particles.key[i] = keyOf(1, i);
    }
    return frame;
}

/// Moves every particle but the first on to this share of its life.
inline void age(Frame& frame, float life)
{
    const auto steps = static_cast<std::int32_t>(life * static_cast<float>(frame.model->schedule().lifetimeSteps));
    frame.step = steps;
    frame.particles.birthStep[0] = steps;
}

/// Particles of 0.2 m and alpha 0.5, whatever their age.
inline Effect evenLook()
{
    Effect effect = thesisEffect(1);
    effect.life.sizeCurve = Curve{{0.0F, 1.0F}};
    effect.life.alphaCurve = Curve{{0.0F, 1.0F}};
    effect.look.size = 0.2F;
    effect.look.sizeVariance = 0.0F;
    effect.look.opacity = 5.0F;
    effect.look.dilution = 0.0F;
    return effect;
}

/// The same under a sun that stands above, scattered once and evenly.
inline Effect lookInSun()
{
    Effect effect = evenLook();
    effect.light.direction = {0.0F, -1.0F, 0.0F};
    effect.light.anisotropy = 0.0F;
    effect.light.shadow = 1.0F;
    effect.light.occlusion = 1.0F;
    effect.light.scattering = 0.0F;
    effect.light.intensity = 1.0F;
    effect.light.resolution = 64;
    return effect;
}

/// Places of a cube of a metre, evenly filled.
inline std::vector<glm::vec3> box(int n)
{
    std::vector<glm::vec3> places;
    for (int x = 0; x < n; ++x) {
        for (int y = 0; y < n; ++y) {
            for (int z = 0; z < n; ++z) {
                places.push_back(glm::vec3(x, y, z) / static_cast<float>(n - 1));
            }
        }
    }
    return places;
}

/// The light of a frame.
struct Lit {
    Appearance appearance;
    LightGrid grid;
    LightWorkspace room;

    Lit(const Frame& frame, const Effect& effect, const glm::vec3& eye = {0.0F, 0.5F, 100.0F})
    {
        findAppearance(frame, sampled(effect), lightAxes(effect.light.direction), appearance);
        const LitLayer layer{&frame, &effect, &appearance, nullptr};
        lightSmoke({&layer, 1}, eye, room, grid);
    }
};

/// A grid of so many cells of one metre.
inline GridShape shapeOf(int nu, int nv, int nw)
{
    GridShape shape;
    shape.nu = nu;
    shape.nv = nv;
    shape.nw = nw;
    return shape;
}

} // namespace fumage::tests
