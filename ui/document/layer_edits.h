#pragma once

#include "ui/document/document.h"

#include <optional>
#include <vector>

namespace fumage::ui {

// What a list of layers does to a document: each is one undo step, and the layers that it is about are chosen
// afterwards.

/// Places of layers in a scene, in their order, each once.
using LayerPlaces = std::vector<std::size_t>;

/// What a layer is called in lists: its name, or its number.
[[nodiscard]] QString layerLabel(const Scene& scene, std::size_t layer);
/// What several are called together: their number, or that of the only one.
[[nodiscard]] QString layersLabel(const Scene& scene, const LayerPlaces& layers);

/// What the list of undo calls it to add the layers of something with a name.
[[nodiscard]] QString addingLayersOf(const QString& name);

/// Adds a new layer after the one that is edited. Nothing happens where there are kMaxLayers.
void addLayer(Document& document);
/// Adds the layers of another preset, as many as fit, with what is not known of them here: without its surroundings,
/// with names and seeds that none has yet.
/// @param at   place of the first of them afterwards
/// @param name of those that have none
/// @param text of the undo step
/// @return how many did not fit
std::size_t insertLayers(
    Document& document, std::size_t at, const Preset& added, const QString& name, const QString& text);
/// The same after the layer that is edited.
std::size_t addLayersOf(Document& document, const Preset& added, const QString& name);
/// Adds copies of layers after the last of them, as many as fit.
void duplicateLayers(Document& document, const LayerPlaces& layers);
/// Nothing happens where none would be left.
/// @param text of the undo step; empty: it says that they are deleted
void removeLayers(Document& document, const LayerPlaces& layers, const QString& text = {});
/// Puts layers beside one another, in their order.
/// @param before place of the layer that they come before, as long as they are where they are; the number of layers:
/// to the end
void moveLayers(Document& document, const LayerPlaces& layers, std::size_t before);
/// What is born on it follows its new name, which no other layer has.
void renameLayer(Document& document, std::size_t layer, const QString& name);
/// Lets layers be born on the particles of another, which is no descendant of theirs, or on their emitters.
void setLayersParent(Document& document, const LayerPlaces& layers, std::optional<std::size_t> parent);
/// Whether layers may be born on another.
[[nodiscard]] bool canBeParent(const Scene& scene, const LayerPlaces& layers, std::size_t parent);
/// Shows or mutes layers; they stay so in files and exports.
void setLayersVisible(Document& document, const LayerPlaces& layers, bool visible);
void setLayersLocked(Document& document, const LayerPlaces& layers, bool locked);
void setLayersTag(Document& document, const LayerPlaces& layers, ColourTag tag);

} // namespace fumage::ui
