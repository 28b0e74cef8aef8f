#pragma once

#include "ui/document/layer_edits.h"

#include "core/preset/preset.h"

#include <string_view>

class QMimeData;

namespace fumage::ui {

// Layers as text: what a preset file would be that has them and nothing else, so that it can be pasted into another
// window, another program and a file.

/// The format of layers that are dragged or copied. What it holds is JSON in UTF-8.
[[nodiscard]] QString layersMimeType();

/// Some layers of a preset in their surroundings, for the clipboard: as plain text, too.
[[nodiscard]] QMimeData* copiedLayers(const Preset& preset, const LayerPlaces& layers);
/// Adds layers to what is dragged; without text, which any field would take.
void addLayers(QMimeData& dragged, const Preset& preset, const LayerPlaces& layers);
/// The same of all layers.
void addLayers(QMimeData& dragged, const Preset& preset);

/// Layers that anybody has put on the clipboard or dragged here; they are checked as files are.
/// @param place what they are called in messages
/// @error those of parsePreset()
[[nodiscard]] Result<PresetReading> layersOf(const QMimeData& data, const std::string& place);

/// The groups of parameters that each layer has of its own, in the order of the panel.
[[nodiscard]] std::vector<std::string_view> layerGroups();
/// Gives layers the parameters of some groups that another layer has, with their key frames, as one step. Each keeps
/// the seed that it has, or they would move alike; those that are locked stay as they are.
/// @param groups of layerGroups()
/// @param name   of the other layer
void pasteGroups(Document& document, const LayerPlaces& layers, const Layer& from,
    const std::vector<std::string_view>& groups, const QString& name);

} // namespace fumage::ui
