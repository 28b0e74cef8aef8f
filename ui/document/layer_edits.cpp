#include "ui/document/layer_edits.h"

#include "ui/document/text.h"

#include <algorithm>
#include <numeric>

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
    constexpr qsizetype kRoom = kMaxLayerName / 4 - 4; // with a number it is none that files refuse
    std::string free = name.toStdString();
    for (int number = 2; isTaken(scene, free); ++number) {
        free = QStringLiteral("%1 %2").arg(name.left(kRoom)).arg(number).toStdString();
    }
    return free;
}

/// Of several layers each has a name: one that goes by its number would have another where it is moved.
void nameAll(Scene& scene)
{
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        if (scene.layers[i].name.empty()) {
            scene.layers[i].name = freeName(scene, LayerEdits::tr("Layer %1").arg(i + 1));
        }
    }
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

/// The layers that an edit was about, of which the one that was edited stays so.
LayerSelection chosen(const Document& document, const LayerPlaces& layers)
{
    const bool isAmongThem = std::binary_search(layers.begin(), layers.end(), document.layer());
    return {isAmongThem ? document.layer() : layers.front(), layers};
}

/// Places that follow on one another.
LayerPlaces placesFrom(std::size_t first, std::size_t count)
{
    LayerPlaces places(count);
    std::iota(places.begin(), places.end(), first);
    return places;
}

/// Changes layers as a step that is named after them.
template <class Change>
void changeLayers(Document& document, const LayerPlaces& layers, const QString& text, const Change& change)
{
    if (layers.empty()) {
        return;
    }
    Scene scene = document.scene();
    for (const std::size_t layer : layers) {
        change(scene.layers[layer]);
    }
    document.replaceScene(scene, chosen(document, layers), text.arg(layersLabel(document.scene(), layers)));
}

/// Takes layers out of a scene.
std::vector<Layer> takeOut(Scene& scene, const LayerPlaces& layers)
{
    std::vector<Layer> taken;
    std::vector<Layer> left;
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        const bool isTaken = std::binary_search(layers.begin(), layers.end(), i);
        (isTaken ? taken : left).push_back(std::move(scene.layers[i]));
    }
    scene.layers = std::move(left);
    return taken;
}

} // namespace

QString layerLabel(const Scene& scene, std::size_t layer)
{
    const std::string& name = scene.layers[layer].name;
    return name.empty() ? LayerEdits::tr("Layer %1").arg(layer + 1) : shortened(onOneLine(toQString(name)));
}

QString layersLabel(const Scene& scene, const LayerPlaces& layers)
{
    return layers.size() == 1 ? layerLabel(scene, layers.front()) : LayerEdits::tr("%1 layers").arg(layers.size());
}

void addLayer(Document& document)
{
    Scene scene = document.scene();
    if (scene.layers.size() >= kMaxLayers) {
        return;
    }
    nameAll(scene);
    Layer added;
    added.name = freeName(scene, LayerEdits::tr("Layer %1").arg(scene.layers.size() + 1));
    added.emitter.seed = freeSeed(scene, added.emitter.seed);
    added.emitter.position = scene.layers[document.layer()].emitter.position;
    scene.layers.insert(scene.layers.begin() + static_cast<std::ptrdiff_t>(document.layer()) + 1, added);
    document.replaceScene(scene, document.layer() + 1, LayerEdits::tr("Add a layer"));
}

std::size_t insertLayers(
    Document& document, std::size_t at, const Preset& added, const QString& name, const QString& text)
{
    const Scene& other = added.scene;
    Scene scene = document.scene();
    const std::size_t fitting = std::min(other.layers.size(), kMaxLayers - scene.layers.size());
    nameAll(scene);
    for (std::size_t i = 0; i < fitting; ++i) {
        Layer layer = other.layers[i];
        layer.name = freeName(scene, layer.name.empty() ? name : toQString(layer.name));
        layer.emitter.seed = freeSeed(scene, layer.emitter.seed);
        scene.layers.insert(scene.layers.begin() + static_cast<std::ptrdiff_t>(at + i), std::move(layer));
    }
    for (std::size_t i = 0; i < fitting; ++i) {
        if (const std::optional<std::size_t> parent = parentOf(other, i)) {
            scene.layers[at + i].from = *parent < fitting ? scene.layers[at + *parent].name : std::string();
        }
    }
    dropBrokenParents(scene);
    if (fitting > 0) {
        document.replaceScene(scene, {at + fitting - 1, placesFrom(at, fitting)}, text);
        std::vector<UnknownMember> said = unknownOf(added, placesFrom(0, fitting));
        for (UnknownMember& member : said) {
            member.layer += at;
        }
        document.addUnknown(said);
    }
    return other.layers.size() - fitting;
}

QString addingLayersOf(const QString& name)
{
    return LayerEdits::tr("Add the layers of “%1”").arg(shortened(onOneLine(name)));
}

std::size_t addLayersOf(Document& document, const Preset& added, const QString& name)
{
    return insertLayers(document, document.layer() + 1, added, name, addingLayersOf(name));
}

void duplicateLayers(Document& document, const LayerPlaces& layers)
{
    if (layers.empty()) {
        return;
    }
    Preset copies;
    copies.scene.layers.clear();
    for (const std::size_t layer : layers) {
        copies.scene.layers.push_back(document.scene().layers[layer]);
        copies.scene.layers.back().name = layerLabel(document.scene(), layer).toStdString();
    }
    copies.unknown = unknownOf(document.preset(), layers);
    insertLayers(document, layers.back() + 1, copies, {},
        LayerEdits::tr("Duplicate %1").arg(layersLabel(document.scene(), layers)));
}

void removeLayers(Document& document, const LayerPlaces& layers, const QString& text)
{
    Scene scene = document.scene();
    if (layers.empty() || layers.size() >= scene.layers.size()) {
        return;
    }
    takeOut(scene, layers);
    dropBrokenParents(scene);
    const auto before = [&](std::size_t place) { // of those that are left
        return place - static_cast<std::size_t>(std::count_if(layers.begin(), layers.end(), [&](std::size_t layer) {
            return layer < place;
        }));
    };
    document.replaceScene(scene, std::min(before(document.layer()), scene.layers.size() - 1),
        text.isEmpty() ? LayerEdits::tr("Delete %1").arg(layersLabel(document.scene(), layers)) : text);
}

void moveLayers(Document& document, const LayerPlaces& layers, std::size_t before)
{
    Scene scene = document.scene();
    std::vector<Layer> moved = takeOut(scene, layers);
    const auto above = std::count_if(layers.begin(), layers.end(), [&](std::size_t layer) { return layer < before; });
    const std::size_t at = before - static_cast<std::size_t>(above);
    scene.layers.insert(scene.layers.begin() + static_cast<std::ptrdiff_t>(at), moved.begin(), moved.end());
    const auto active = std::find(layers.begin(), layers.end(), document.layer());
    const std::size_t place = active == layers.end() ? 0 : static_cast<std::size_t>(active - layers.begin());
    document.replaceScene(scene, {at + place, placesFrom(at, moved.size())},
        LayerEdits::tr("Move %1").arg(layersLabel(document.scene(), layers)));
}

void renameLayer(Document& document, std::size_t layer, const QString& name)
{
    Scene scene = document.scene();
    LayerPlaces children;
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        if (parentOf(scene, i) == layer) {
            children.push_back(i);
        }
    }
    const QString text = name.trimmed().left(static_cast<qsizetype>(kMaxLayerName / 4));
    std::string& own = scene.layers[layer].name;
    if (text.toStdString() == own) {
        return;
    }
    own.clear(); // it is none that is taken
    own = text.isEmpty() ? std::string() : freeName(scene, text);
    for (const std::size_t child : children) {
        scene.layers[child].from = own;
    }
    document.replaceScene(
        scene, chosen(document, {layer}), LayerEdits::tr("Rename %1").arg(layerLabel(document.scene(), layer)));
}

bool canBeParent(const Scene& scene, const LayerPlaces& layers, std::size_t parent)
{
    return std::none_of(
        layers.begin(), layers.end(), [&](std::size_t layer) { return isBornOn(scene, parent, layer); });
}

void setLayersParent(Document& document, const LayerPlaces& layers, std::optional<std::size_t> parent)
{
    Scene scene = document.scene();
    if (layers.empty() || (parent && !canBeParent(scene, layers, *parent))) {
        return;
    }
    std::string name;
    if (parent) {
        // It is known by its name, which it may not have yet, or share with another.
        std::string& own = scene.layers[*parent].name;
        const auto sharing = std::count_if(
            scene.layers.begin(), scene.layers.end(), [&](const Layer& layer) { return layer.name == own; });
        if (own.empty() || sharing > 1) {
            const QString label = layerLabel(scene, *parent);
            own.clear();
            own = freeName(scene, label);
        }
        name = own;
    }
    for (const std::size_t layer : layers) {
        scene.layers[layer].from = name;
    }
    const QString text = parent
        ? LayerEdits::tr("%1: born on %2").arg(layersLabel(document.scene(), layers), layerLabel(scene, *parent))
        : LayerEdits::tr("%1: born on the emitter").arg(layersLabel(document.scene(), layers));
    document.replaceScene(scene, chosen(document, layers), text);
}

void setLayersVisible(Document& document, const LayerPlaces& layers, bool visible)
{
    changeLayers(document, layers, visible ? LayerEdits::tr("Show %1") : LayerEdits::tr("Mute %1"),
        [&](Layer& changed) { changed.visible = visible; });
}

void setLayersLocked(Document& document, const LayerPlaces& layers, bool locked)
{
    changeLayers(document, layers, locked ? LayerEdits::tr("Lock %1") : LayerEdits::tr("Unlock %1"),
        [&](Layer& changed) { changed.locked = locked; });
}

void setLayersTag(Document& document, const LayerPlaces& layers, ColourTag tag)
{
    changeLayers(document, layers, LayerEdits::tr("Colour tag of %1"), [&](Layer& changed) { changed.tag = tag; });
}

} // namespace fumage::ui
