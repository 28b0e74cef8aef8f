#pragma once

#include "ui/document/document.h"

#include "core/preset/preset_file.h"

#include <vector>

namespace fumage::ui {

/// Layers as many effects have them, taken from a built-in preset.
struct LayerTemplate {
    QString name; ///< as menus show it
    const char* preset = ""; ///< of which they are
    std::vector<const char*> layers; ///< what they are called there, in their order
};

[[nodiscard]] std::vector<LayerTemplate> layerTemplates();

/// The layers of a template for a document: they stand to the emitter of the layer that is edited as they stand to that
/// of the first layer of their preset, and go its way, or none.
/// @error those of loadPreset()
[[nodiscard]] Result<PresetReading> layersOf(const LayerTemplate& from, const Document& document);

} // namespace fumage::ui
