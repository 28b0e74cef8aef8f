#include "ui/document/layer_clipboard.h"

#include "ui/document/parameter_text.h"
#include "ui/document/text.h"
#include "ui/document/unknown_places.h"

#include "core/effect/known_parameter.h"
#include "core/effect/parameter_table.h"
#include "core/preset/preset_file.h"

#include <algorithm>

#include <QCoreApplication>
#include <QMimeData>

namespace fumage::ui {

namespace {

struct LayerClipboard {
    Q_DECLARE_TR_FUNCTIONS(LayerClipboard)
};

/// A preset that has some of the layers, with what files said of those that this program does not know.
Preset partOf(const Preset& preset, const LayerPlaces& layers)
{
    Preset part;
    part.name = layers.size() == 1 ? preset.scene.layers[layers.front()].name : preset.name;
    part.scene = preset.scene;
    part.scene.layers.clear();
    for (const std::size_t layer : layers) {
        part.scene.layers.push_back(preset.scene.layers[layer]);
    }
    dropBrokenParents(part.scene);
    part.unknown = unknownOf(preset, layers);
    return part;
}

} // namespace

QString layersMimeType()
{
    return QStringLiteral("application/x-fumage-preset+json");
}

QMimeData* copiedLayers(const Preset& preset, const LayerPlaces& layers)
{
    auto* data = new QMimeData;
    addLayers(*data, preset, layers);
    data->setText(QString::fromUtf8(data->data(layersMimeType())));
    return data;
}

void addLayers(QMimeData& dragged, const Preset& preset, const LayerPlaces& layers)
{
    addLayers(dragged, partOf(preset, layers));
}

void addLayers(QMimeData& dragged, const Preset& preset)
{
    const std::string text = formatPreset(preset);
    dragged.setData(layersMimeType(), QByteArray(text.data(), static_cast<qsizetype>(text.size())));
}

Result<PresetReading> layersOf(const QMimeData& data, const std::string& place)
{
    const QByteArray bytes = data.hasFormat(layersMimeType()) ? data.data(layersMimeType()) : data.text().toUtf8();
    return parsePreset(std::string_view(bytes.data(), static_cast<std::size_t>(bytes.size())), place);
}

std::vector<std::string_view> layerGroups()
{
    std::vector<std::string_view> groups;
    for (const Parameter& parameter : parameterTable()) {
        if (parameter.scope == Scope::Layer
            && std::find(groups.begin(), groups.end(), parameter.group()) == groups.end()) {
            groups.push_back(parameter.group());
        }
    }
    return groups;
}

void pasteGroups(Document& document, const LayerPlaces& layers, const Layer& from,
    const std::vector<std::string_view>& groups, const QString& name)
{
    Scene source = document.scene();
    source.layers = {from};
    const Effect values = source.effect();
    Scene scene = document.scene();
    QStringList labels;
    for (const std::string_view group : groups) {
        labels += groupLabelOf(group);
    }
    for (const std::size_t layer : layers) {
        if (scene.layers[layer].locked) {
            continue;
        }
        Effect effect = scene.effect(layer);
        for (const Parameter& parameter : parameterTable()) {
            const bool isMeant = std::find(groups.begin(), groups.end(), parameter.group()) != groups.end();
            if (parameter.scope == Scope::Layer && isMeant && &parameter != &knownParameter("emitter.seed")) {
                parameter.set(effect, parameter.get(values));
                // Key frames would go on to hide the value, or stay behind.
                const Track* track = from.tracks.find(parameter);
                scene.layers[layer].tracks.set(track != nullptr ? *track : Track{&parameter, {}});
            }
        }
        scene.assign(layer, effect);
    }
    document.replaceScene(scene, document.selection(),
        LayerClipboard::tr("Paste %1 of “%2”").arg(labels.join(QStringLiteral(", ")), shortened(onOneLine(name))));
}

} // namespace fumage::ui
