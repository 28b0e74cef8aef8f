#pragma once

#include "core/scene/scene.h"
#include "core/export/image_file.h"
#include "core/export/layer_output.h"
#include "core/export/pass_picture.h"
#include "core/export/sheets/sheet_events.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fumage {

/// One picture of a flipbook, as it is written.
struct EnginePicture {
    std::optional<Pass> pass; ///< none: it is packed
    std::filesystem::path file;
    std::span<const std::byte> bytes;
    bool isSrgb = false; ///< else its numbers are linear
    bool isExact = false; ///< vectors and normals are no colours: mixed or compressed as such they point elsewhere
    std::string layer{}; ///< whose colour it is, where layers are stacked; may be empty
};

/// All that files for engines tell of a flipbook.
struct EngineSheet {
    const Scene& scene; ///< its output is a cell
    int columns = 1;
    int rows = 1;
    double cellsPerSecond = 1.0;
    bool loops = false; ///< it is played over and over
    PassStyle style;
    PassScales scales;
    std::vector<EnginePicture> pictures; ///< the first is the colour's
    std::filesystem::path named{}; ///< the picture whose name is that of the files; empty: the first
    bool isStacked = false; ///< the pictures are layers in the order in which they are drawn, premultiplied unless the
                            ///< engine blendsStraight()
    BlendSpace space = BlendSpace::Encoded; ///< in which they are the picture then
    std::vector<SheetEvent> events{}; ///< markers, as they are passed
};

} // namespace fumage
