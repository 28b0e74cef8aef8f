#include "ui/preview/trails.h"

#include "core/effect/sampling.h"
#include "core/simulation/simulator.h"

#include <algorithm>

namespace fumage::ui {

std::vector<Trail> findTrails(const Effect& effect, int frame, const std::shared_ptr<AirCache>& shelf)
{
    constexpr int kParticles = 60;
    constexpr int kFrames = 150;
    Simulator simulator(thinned(sampled(effect), kParticles), 0, shelf);
    std::vector<Trail> trails;
    std::vector<std::int32_t> births;
    for (int number = std::max(0, frame - kFrames); number <= frame; ++number) {
        const Result<std::shared_ptr<const Frame>> result = simulator.frame(number);
        if (!result) {
            return {};
        }
        const Particles& particles = result.value()->particles;
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
