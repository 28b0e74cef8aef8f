#include "ui/document/layer_templates.h"

#include "core/effect/known_parameter.h"
#include "core/preset/library.h"

#include <algorithm>
#include <string_view>

#include <QCoreApplication>

namespace fumage::ui {

namespace {

struct LayerTemplates {
    Q_DECLARE_TR_FUNCTIONS(LayerTemplates)
};

constexpr const Parameter& kPosition = knownParameter("emitter.position");

void keepOnly(Scene& scene, const std::vector<const char*>& names)
{
    std::erase_if(scene.layers, [&](const Layer& layer) {
        return std::none_of(names.begin(), names.end(), [&](std::string_view name) { return name == layer.name; });
    });
}

Track movedBy(Track track, const glm::vec3& way)
{
    for (KeyFrame& key : track.keys) {
        std::get<glm::vec3>(key.value) += way;
    }
    return track;
}

} // namespace

std::vector<LayerTemplate> layerTemplates()
{
    return {
        {LayerTemplates::tr("Flames"), "bonfire", {"Flames"}},
        {LayerTemplates::tr("Embers"), "bonfire", {"Embers"}},
        {LayerTemplates::tr("Sparks"), "forge-sparks", {"Sparks"}},
        {LayerTemplates::tr("Fireball"), "blast", {"Fireball"}},
        {LayerTemplates::tr("Debris with trails"), "blast", {"Debris", "Trails"}},
        {LayerTemplates::tr("Dust ring"), "blast", {"Dust ring"}},
        {LayerTemplates::tr("Jet"), "rocket-launch", {"Jet"}},
        {LayerTemplates::tr("Falling fog"), "dry-ice", {"Fog"}},
        {LayerTemplates::tr("Glitter"), "glitter", {"Glitter"}},
        {LayerTemplates::tr("Halo"), "candle", {"Halo"}},
    };
}

Result<PresetReading> layersOf(const LayerTemplate& from, const Document& document)
{
    Result<PresetReading> reading = loadPreset(LibraryEntry{from.preset, {}});
    if (!reading) {
        return reading;
    }
    Scene& scene = reading.value().preset.scene;
    const Layer& edited = document.scene().layers[document.layer()];
    const glm::vec3 way = edited.emitter.position - scene.layers.front().emitter.position;
    const Track* moves = edited.tracks.find(kPosition);
    keepOnly(scene, from.layers);
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        Layer& layer = scene.layers[i];
        layer.emitter.position += way;
        const bool goesAlong = moves != nullptr && !parentOf(scene, i);
        layer.tracks.set(
            goesAlong ? movedBy(*moves, layer.emitter.position - edited.emitter.position) : Track{&kPosition, {}});
    }
    if (scene.layers.size() == 1) {
        scene.layers.front().name = from.name.toStdString();
    }
    return reading;
}

} // namespace fumage::ui
