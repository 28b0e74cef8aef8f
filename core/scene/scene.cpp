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

/// The layers of a name.
struct Named {
    std::size_t first = 0;
    std::size_t count = 0;

    [[nodiscard]] std::optional<std::size_t> only() const { return count == 1 ? std::optional(first) : std::nullopt; }
};

Named layersNamed(const Scene& scene, std::string_view name)
{
    Named named;
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        if (scene.layers[i].name == name) {
            named.first = named.count == 0 ? i : named.first;
            ++named.count;
        }
    }
    return named;
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

Effect Scene::effectAt(std::size_t layer, double seconds) const
{
    Effect out = effect(layer);
    for (const Tracks* all : {&tracks, &layers[layer].tracks}) {
        for (const Track& track : all->all()) {
            track.parameter->set(out, track.at(seconds));
        }
    }
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

Tracks& Scene::tracksOf(const Parameter& parameter, std::size_t layer)
{
    return parameter.scope == Scope::Scene ? tracks : layers[layer].tracks;
}

const Tracks& Scene::tracksOf(const Parameter& parameter, std::size_t layer) const
{
    return parameter.scope == Scope::Scene ? tracks : layers[layer].tracks;
}

Tracks Scene::allTracks(std::size_t layer) const
{
    Tracks all = tracks;
    all.add(layers[layer].tracks);
    return all;
}

Scene Scene::atFrame(int number) const
{
    Scene out = *this;
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
        if (const Tracks all = allTracks(layer); !all.empty()) {
            Effect now = effect(layer);
            readFrame(all, number, now);
            out.assign(layer, now);
            out.layers[layer].tracks = {};
        }
    }
    out.tracks = {};
    return out;
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
    const Named named = layersNamed(scene, nameOrNumber);
    if (named.count > 0) {
        return named.only();
    }
    const std::optional<std::int64_t> number = parseInteger(nameOrNumber);
    const bool isThere = number && *number >= 1 && *number <= static_cast<std::int64_t>(scene.layers.size());
    return isThere ? std::optional(static_cast<std::size_t>(*number - 1)) : std::nullopt;
}

std::optional<std::size_t> parentOf(const Scene& scene, std::size_t layer)
{
    const std::string& name = scene.layers[layer].from;
    return name.empty() ? std::nullopt : layersNamed(scene, name).only();
}

bool isBornOn(const Scene& scene, std::size_t layer, std::size_t ancestor)
{
    std::optional<std::size_t> next = layer;
    for (std::size_t steps = 0; next && steps <= scene.layers.size(); ++steps) {
        if (*next == ancestor) {
            return true;
        }
        next = parentOf(scene, *next);
    }
    return false;
}

Status checkParent(const Scene& scene, std::size_t layer)
{
    if (scene.layers[layer].from.empty()) {
        return Done{};
    }
    const std::optional<std::size_t> next = parentOf(scene, layer);
    if (!next) {
        return Error{ErrorCode::UnknownName,
            makeMessage("there is no one layer %1 to be born on", inQuotes(scene.layers[layer].from)), {},
            makeMessage("Name a layer that no other shares its name with")};
    }
    if (isBornOn(scene, *next, layer)) {
        return Error{ErrorCode::OutOfRange,
            makeMessage("layer %1 would be born on itself, by way of %2", inQuotes(scene.layers[layer].name),
                inQuotes(scene.layers[layer].from)),
            {}, makeMessage("Let one layer of the ring be born on its emitter")};
    }
    return Done{};
}

void dropBrokenParents(Scene& scene)
{
    for (std::size_t layer = 0; layer < scene.layers.size(); ++layer) {
        if (!checkParent(scene, layer)) {
            scene.layers[layer].from.clear();
        }
    }
}

std::int64_t particlesOf(SampledLayers layers)
{
    std::int64_t sum = 0;
    for (const SampledEffect& layer : layers) {
        sum += layer->emitter.count;
    }
    return sum;
}

namespace {

/// A layer in its surroundings; what is born on another has no source in the air.
Effect effectInScene(const Scene& scene, std::size_t layer)
{
    Effect effect = scene.effect(layer);
    effect.source.feeds = effect.source.feeds && !parentOf(scene, layer);
    return effect;
}

/// The layer that others are born on is as many whatever the quality: by its numbers one knows what was born on what.
SampledEffect atGoodQuality(const Scene& scene, std::size_t layer)
{
    Effect effect = effectInScene(scene, layer);
    effect.output.quality = Quality::Good;
    return sampled(effect, scene.allTracks(layer));
}

/// A layer with those that it is born on.
/// @param depth how many are on the way to it: a ring ends
SampledEffect withParents(const Scene& scene, std::size_t layer, SampledEffect own, std::size_t depth = 0)
{
    const std::optional<std::size_t> parent = parentOf(scene, layer);
    if (parent && depth < scene.layers.size()) {
        own.setParent(std::make_shared<const SampledEffect>(
            withParents(scene, *parent, atGoodQuality(scene, *parent), depth + 1)));
    }
    return own;
}

/// Whether another of the layers is born on one.
bool isParent(SampledLayers layers, const SampledEffect& layer)
{
    return std::any_of(layers.begin(), layers.end(),
        [&](const SampledEffect& other) { return other.parent() && *other.parent() == layer; });
}

/// Whether another layer of the scene is born on one.
bool isParent(const Scene& scene, std::size_t layer)
{
    for (std::size_t other = 0; other < scene.layers.size(); ++other) {
        if (parentOf(scene, other) == layer) {
            return true;
        }
    }
    return false;
}

} // namespace

Effect simulatedEffect(const Scene& scene, std::size_t layer)
{
    Effect effect = effectInScene(scene, layer);
    const bool keeps = !scene.layers[layer].visible || effect.emitter.count <= kMaxKeptParents;
    if (keeps && isParent(scene, layer)) {
        effect.output.quality = Quality::Good;
    }
    return effect;
}

void thinLayers(std::vector<SampledEffect>& layers, std::int64_t most)
{
    std::vector<bool> keeps;
    std::int64_t kept = 0;
    for (const SampledEffect& layer : layers) {
        keeps.push_back(layer->emitter.count <= kMaxKeptParents && isParent(layers, layer));
        kept += keeps.back() ? layer->emitter.count : 0;
    }
    const std::int64_t all = particlesOf(layers) - kept;
    const std::int64_t left = std::max<std::int64_t>(1, most - kept);
    for (std::size_t i = 0; all > left && i < layers.size(); ++i) {
        const std::int64_t share = layers[i]->emitter.count * left / all;
        if (!keeps[i]) {
            layers[i] = thinned(layers[i], static_cast<int>(std::max<std::int64_t>(1, share)));
        }
    }
}

SampledEffect sampledLayer(const Scene& scene, std::size_t layer)
{
    return withParents(scene, layer, sampled(simulatedEffect(scene, layer), scene.allTracks(layer)));
}

std::vector<SampledEffect> sampledLayers(const Scene& scene)
{
    std::vector<SampledEffect> out;
    for (const std::size_t layer : scene.visibleLayers()) {
        out.push_back(sampledLayer(scene, layer));
    }
    if (out.empty()) {
        Effect nothing = scene.effect();
        nothing.emitter.count = 1;
        nothing.look.opacity = 0.0F;
        nothing.source.feeds = false;
        return {sampled(nothing, scene.tracks)};
    }
    thinLayers(out, kMaxParticles);
    return out;
}

} // namespace fumage
