#include "ui/preview/trails.h"

#include "core/effect/sampling.h"
#include "core/simulation/scene_simulator.h"

#include <algorithm>

namespace fumage::ui {

std::vector<Trail> findTrails(const Scene& scene, std::size_t layer, int frame, const std::shared_ptr<AirCache>& shelf)
{
    constexpr int kParticles = 60;
    constexpr int kFrames = 150;
    Scene thin = scene;
    thin.layers[layer].visible = true; // the ways of a layer that is not seen, too
    std::vector<SampledEffect> layers = sampledLayers(thin);
    const std::vector<std::size_t> visible = thin.visibleLayers();
    const auto place = static_cast<std::size_t>(std::find(visible.begin(), visible.end(), layer) - visible.begin());
    for (SampledEffect& each : layers) {
        each = thinned(each, kParticles);
    }
    SceneSimulator simulator(layers, 0, shelf);
    std::vector<Trail> trails;
    std::vector<std::int32_t> births;
    for (int number = std::max(0, frame - kFrames); number <= frame; ++number) {
        const Result<SceneFrame> result = simulator.frame(number);
        if (!result) {
            return {};
        }
        const Particles& particles = result.value().layers[place]->particles;
        trails.resize(particles.capacity);
        births.resize(particles.capacity, Particles::kUnborn);
        for (std::size_t i = 0; i < particles.capacity; ++i) {
            if (births[i] != particles.birthStep[i]) {
                births[i] = particles.birthStep[i];
                trails[i].clear();
            }
            if (births[i] != Particles::kUnborn) {
                trails[i].emplace_back(particles.x[i], particles.y[i], particles.z[i]);
            }
        }
    }
    return trails;
}

} // namespace fumage::ui
