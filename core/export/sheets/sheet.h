#pragma once

#include "core/base/task.h"
#include "core/export/export_task.h"
#include "core/export/frame_neighbours.h"
#include "core/export/frame_source.h"
#include "core/export/pass_picture.h"
#include "core/rendering/pass_renderer.h"
#include "core/simulation/air_cache.h"
#include "core/scene/scene.h"

#include <functional>
#include <vector>

#include <glm/vec2.hpp>

namespace fumage {

/// Makes room for the cells of a grid; what the last row has more is empty.
void makeRoom(const SheetGrid& grid, Image& sheet);
/// Puts a cell into its place.
/// @param number below grid.cells
void placeCell(const SheetGrid& grid, int number, const Image& cell, Image& sheet);

/// Sees each cell as it is placed, in their order: its targets, its frame, and what can make more of it. Its error ends
/// the work.
using CellWatch = std::function<Status(const PassImages& cell, const FrameAmongOthers& frame, PassRenderer& renderer)>;

/// Renders frames into the cells of a sheet, first at the top left, then along the rows, each of effect.output's size
/// and without background.
/// @param frames  of the cells, in any order, but one that rises is quick; for motion one more frame is simulated,
/// unless they close a loop: as far behind the last as that is behind the one before
/// @param columns the cells fill rows of as many
/// @param passes  what the targets must do for
/// @error those of Simulator and PassRenderer
[[nodiscard]] Status renderSheet(const Scene& scene, const CellFrames& frames, int columns, PassSet passes,
    PassSheet& sheet, const CellWatch& watch, const ExportTask& task = {});

/// Fills the colour of a sheet with frames that are there already.
/// @param size of a cell, pixels
/// @error those of the frames; Cancelled
[[nodiscard]] Status joinSheet(const CellFrames& frames, int columns, const FrameSource& source, const glm::ivec2& size,
    PassSheet& sheet, const Task& task = {});

} // namespace fumage
