#include "ui/preview/picture_plan.h"

#include <algorithm>

namespace fumage::ui {

PicturePlan::PicturePlan(const Scene& scene, const std::vector<std::size_t>& solo)
{
    takeLayersOf(scene);
    const std::vector<std::size_t> visible = scene.visibleLayers();
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (solo.empty() || (i < visible.size() && std::find(solo.begin(), solo.end(), visible[i]) != solo.end())) {
            drawn.push_back(i);
        }
    }
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        if (!scene.layers[i].visible) {
            muted.push_back(sampledLayer(scene, i));
        }
    }
}

void PicturePlan::takeLayersOf(const Scene& scene)
{
    layers = sampledLayers(scene);
    particles = static_cast<int>(particlesOf(layers));
}

void PicturePlan::thinTo(int most)
{
    thinLayers(layers, most);
    particles = static_cast<int>(particlesOf(layers));
}

void PicturePlan::drawSparsely(int most)
{
    sparse = layers;
    thinLayers(sparse, most);
}

Schedule PicturePlan::longestSchedule() const
{
    Schedule longest = makeSchedule(layers.front());
    for (std::size_t i = 1; i < layers.size(); ++i) {
        const Schedule own = makeSchedule(layers[i]);
        longest = own.lifetimeSteps > longest.lifetimeSteps ? own : longest;
    }
    return longest;
}

double PicturePlan::drawnShare() const
{
    double sum = 0.0;
    for (const std::size_t layer : drawn) {
        sum += layers[layer]->emitter.count;
    }
    return sum / std::max(1, particles);
}

int PicturePlan::drawnParticles() const
{
    int sum = 0;
    for (const std::size_t layer : drawn) {
        sum += looks()[layer]->emitter.count;
    }
    return sum;
}

} // namespace fumage::ui
