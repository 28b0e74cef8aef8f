#pragma once

#include "core/base/task.h"
#include "core/export/sheets/flipbook_options.h"
#include "core/scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fumage {

/// What the file of one layer's sheet shows.
struct LayerSheetScore {
    std::string layer; ///< as the scene has it
    std::filesystem::path file;
    double seen = 0.0; ///< share of the pixels that are not clear: alpha or light of 1/255 or more
    int empty = 0; ///< cells without any
    float edgeAlpha = 0.0F; ///< most alpha on a cell's border
};

/// What the files of a layered sheet show.
struct LayeredScore {
    std::vector<LayerSheetScore> sheets; ///< in the order in which they are drawn
    /// What they make together over black, in the numbers in which they are blended, against the sheet of all layers,
    /// which is rendered again; see Difference. None of layers alone, which make no picture together.
    std::optional<double> decibels;
};

/// Sheets of layers, and where they lie.
struct LayeredSheets {
    Scene scene; ///< that they show
    FlipbookOptions options; ///< with the path that the sheet of all would have
};

/// The sheets that a manifest names, or those that belong to one of them.
/// @param file a manifest of one flipbook, or a picture that carries its preset
/// @return     nothing where it is a picture that shows no layer of several sheets
/// @error OutOfRange where a manifest is of none; those of readManifest() and readPresetFile()
[[nodiscard]] Result<std::optional<LayeredSheets>> findLayeredSheets(const std::filesystem::path& file);

/// Looks at the sheets of all layers, and puts them together as an engine does: adds contributions up, and draws
/// stacked ones over one another.
/// @error FileNotFound where one is missing; OutOfRange where one has another size, or they have no colour; those of
/// the readers and of encodeFlipbook()
/// O(pixels * layers), and the rendering of the sheet.
[[nodiscard]] Result<LayeredScore> scoreLayers(const LayeredSheets& layered, const Task& task = {});

} // namespace fumage
