#include "ui/document/layer_edits.h"

#include "ui/document/text.h"

#include <algorithm>

#include <QCoreApplication>

namespace fumage::ui {

namespace {

struct LayerEdits {
    Q_DECLARE_TR_FUNCTIONS(LayerEdits)
};

bool isTaken(const Scene& scene, const std::string& name)
{
    return std::any_of(
        scene.layers.begin(), scene.layers.end(), [&](const Layer& layer) { return layer.name == name; });
}

/// A name that no layer has: the one asked for, or with a number after it.
std::string freeName(const Scene& scene, const QString& name)
{
    std::string free = name.toStdString();
    for (int number = 2; isTaken(scene, free); ++number) {
        free = QStringLiteral("%1 %2").arg(name).arg(number).toStdString();
    }
    return free;
}

/// No two layers move alike because they have one seed.
std::uint32_t freeSeed(const Scene& scene, std::uint32_t seed)
{
    while (std::any_of(
        scene.layers.begin(), scene.layers.end(), [&](const Layer& layer) { return layer.emitter.seed == seed; })) {
        ++seed;
    }
    return seed;
}

void insertAfter(Scene& scene, std::size_t layer, Layer added)
{
    scene.layers.insert(scene.layers.begin() + static_cast<std::ptrdiff_t>(layer) + 1, std::move(added));
}

/// Changes a layer as a step that is named after it.
template <class Change>
void changeLayer(Document& document, std::size_t layer, const QString& text, const Change& change)
{
    Scene scene = document.scene();
    change(scene.layers[layer]);
    document.replaceScene(scene, layer, text.arg(layerLabel(document.scene(), layer)));
}

} // namespace

QString layerLabel(const Scene& scene, std::size_t layer)
{
    const std::string& name = scene.layers[layer].name;
    return name.empty() ? LayerEdits::tr("Layer %1").arg(layer + 1) : shortened(onOneLine(toQString(name)));
}

void addLayer(Document& document)
{
    Scene scene = document.scene();
    if (scene.layers.size() >= kMaxLayers) {
        return;
    }
    Layer added;
    added.name = freeName(scene, LayerEdits::tr("Layer %1").arg(scene.layers.size() + 1));
    added.emitter.seed = freeSeed(scene, added.emitter.seed);
    added.emitter.position = scene.layers[document.layer()].emitter.position;
    insertAfter(scene, document.layer(), added);
    document.replaceScene(scene, document.layer() + 1, LayerEdits::tr("Add a layer"));
}

void addLayersOf(Document& document, const Scene& other, const QString& name)
{
    Scene scene = document.scene();
    std::size_t at = document.layer();
    for (Layer layer : other.layers) {
        if (scene.layers.size() >= kMaxLayers) {
            break;
        }
        layer.name = freeName(scene, layer.name.empty() ? name : toQString(layer.name));
        layer.emitter.seed = freeSeed(scene, layer.emitter.seed);
        insertAfter(scene, at++, std::move(layer));
    }
    document.replaceScene(scene, at, LayerEdits::tr("Add the layers of “%1”").arg(shortened(onOneLine(name))));
}

void duplicateLayer(Document& document, std::size_t layer)
{
    Scene scene = document.scene();
    if (scene.layers.size() >= kMaxLayers) {
        return;
    }
    Layer copy = scene.layers[layer];
    copy.name = freeName(scene, layerLabel(scene, layer));
    copy.emitter.seed = freeSeed(scene, copy.emitter.seed);
    insertAfter(scene, layer, std::move(copy));
    document.replaceScene(scene, layer + 1, LayerEdits::tr("Duplicate %1").arg(layerLabel(document.scene(), layer)));
}

void removeLayer(Document& document, std::size_t layer)
{
    Scene scene = document.scene();
    if (scene.layers.size() == 1) {
        return;
    }
    scene.layers.erase(scene.layers.begin() + static_cast<std::ptrdiff_t>(layer));
    const std::size_t active = document.layer();
    const std::size_t next = std::min(active > layer ? active - 1 : active, scene.layers.size() - 1);
    document.replaceScene(scene, next, LayerEdits::tr("Delete %1").arg(layerLabel(document.scene(), layer)));
}

void moveLayer(Document& document, std::size_t layer, std::size_t to)
{
    Scene scene = document.scene();
    Layer moved = std::move(scene.layers[layer]);
    scene.layers.erase(scene.layers.begin() + static_cast<std::ptrdiff_t>(layer));
    scene.layers.insert(scene.layers.begin() + static_cast<std::ptrdiff_t>(to), std::move(moved));
    document.replaceScene(scene, to, LayerEdits::tr("Move %1").arg(layerLabel(document.scene(), layer)));
}

void renameLayer(Document& document, std::size_t layer, const QString& name)
{
    const std::string text = name.trimmed().left(static_cast<qsizetype>(kMaxLayerName / 4)).toStdString();
    changeLayer(document, layer, LayerEdits::tr("Rename %1"), [&](Layer& changed) { changed.name = text; });
}

void setLayerVisible(Document& document, std::size_t layer, bool visible)
{
    changeLayer(document, layer, visible ? LayerEdits::tr("Show %1") : LayerEdits::tr("Mute %1"),
        [&](Layer& changed) { changed.visible = visible; });
}

void setLayerLocked(Document& document, std::size_t layer, bool locked)
{
    changeLayer(document, layer, locked ? LayerEdits::tr("Lock %1") : LayerEdits::tr("Unlock %1"),
        [&](Layer& changed) { changed.locked = locked; });
}

void setLayerTag(Document& document, std::size_t layer, ColourTag tag)
{
    changeLayer(document, layer, LayerEdits::tr("Colour tag of %1"), [&](Layer& changed) { changed.tag = tag; });
}

} // namespace fumage::ui
