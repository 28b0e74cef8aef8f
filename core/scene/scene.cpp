#include "core/scene/scene.h"

#include "core/base/text.h"

#include <algorithm>

namespace fumage {

namespace {

void copySurroundings(const auto& from, auto& to)
{
    to.wind = from.wind;
    to.air = from.air;
    to.light = from.light;
    to.camera = from.camera;
    to.timeline = from.timeline;
    to.output = from.output;
}

void copyLayer(const auto& from, auto& to)
{
    to.emitter = from.emitter;
    to.source = from.source;
    to.motion = from.motion;
    to.turbulence = from.turbulence;
    to.vortex = from.vortex;
    to.rings = from.rings;
    to.life = from.life;
    to.look = from.look;
    to.noise = from.noise;
    to.glow = from.glow;
}

} // namespace

Scene::Scene(const Effect& effect)
{
    assign(0, effect);
}

Effect Scene::effect(std::size_t layer) const
{
    Effect out;
    copySurroundings(*this, out);
    copyLayer(layers[layer], out);
    return out;
}

void Scene::setSurroundings(const Effect& effect)
{
    copySurroundings(effect, *this);
}

void Scene::assign(std::size_t layer, const Effect& effect)
{
    setSurroundings(effect);
    copyLayer(effect, layers[layer]);
}

std::vector<std::size_t> Scene::visibleLayers() const
{
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (layers[i].visible) {
            out.push_back(i);
        }
    }
    return out;
}

std::int64_t Scene::particles() const
{
    std::int64_t sum = 0;
    for (const std::size_t layer : visibleLayers()) {
        sum += layers[layer].emitter.count;
    }
    return sum;
}

std::optional<std::size_t> findLayer(const Scene& scene, std::string_view nameOrNumber)
{
    const auto isNamed = [&](const Layer& layer) { return layer.name == nameOrNumber; };
    const auto found = std::find_if(scene.layers.begin(), scene.layers.end(), isNamed);
    if (found != scene.layers.end()) {
        const bool isOnly = std::find_if(found + 1, scene.layers.end(), isNamed) == scene.layers.end();
        return isOnly ? std::optional(static_cast<std::size_t>(found - scene.layers.begin())) : std::nullopt;
    }
    const std::optional<std::int64_t> number = parseInteger(nameOrNumber);
    const bool isThere = number && *number >= 1 && *number <= static_cast<std::int64_t>(scene.layers.size());
    return isThere ? std::optional(static_cast<std::size_t>(*number - 1)) : std::nullopt;
}

std::vector<SampledEffect> sampledLayers(const Scene& scene)
{
    std::vector<SampledEffect> out;
    std::int64_t particles = 0;
    for (const std::size_t layer : scene.visibleLayers()) {
        out.push_back(sampled(scene.effect(layer)));
        particles += out.back()->emitter.count;
    }
    if (out.empty()) {
        Effect nothing = scene.effect();
        nothing.emitter.count = 1;
        nothing.look.opacity = 0.0F;
        nothing.source.feeds = false;
        return {sampled(nothing)};
    }
    for (SampledEffect& layer : out) {
        if (particles > kMaxParticles) {
            const std::int64_t share = layer->emitter.count * std::int64_t{kMaxParticles} / particles;
            layer = thinned(layer, static_cast<int>(std::max<std::int64_t>(1, share)));
        }
    }
    return out;
}

} // namespace fumage
