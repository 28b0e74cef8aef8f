#pragma once

#include "ui/document/document.h"

namespace fumage::ui {

// What a list of layers does to a document: each is one undo step, and the layer it is about is edited afterwards.

/// What a layer is called in lists: its name, or its number.
[[nodiscard]] QString layerLabel(const Scene& scene, std::size_t layer);

/// Adds a new layer after the one that is edited. Nothing happens where there are kMaxLayers.
void addLayer(Document& document);
/// Adds the layers of another scene after the one that is edited, as many as fit: without its surroundings.
void addLayersOf(Document& document, const Scene& other, const QString& name);
/// Adds a copy of a layer after it.
void duplicateLayer(Document& document, std::size_t layer);
/// Nothing happens to the last one that is left.
void removeLayer(Document& document, std::size_t layer);
/// @param to place among the others afterwards
void moveLayer(Document& document, std::size_t layer, std::size_t to);
void renameLayer(Document& document, std::size_t layer, const QString& name);
/// Shows or mutes a layer; it stays so in files and exports.
void setLayerVisible(Document& document, std::size_t layer, bool visible);
void setLayerLocked(Document& document, std::size_t layer, bool locked);
void setLayerTag(Document& document, std::size_t layer, ColourTag tag);

} // namespace fumage::ui
