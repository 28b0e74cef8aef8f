#pragma once

#include "core/export/sheets/flipbook_options.h"
#include "core/export/frame_neighbours.h"
#include "core/scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace fumage {

/// Reads points as curves of parameters have them, "[[0, 0], [0.3, 0.6], [1, 1]]".
/// @error WrongType; OutOfRange where they do not lie between 0 and 1, from left to right
[[nodiscard]] Result<Curve> parseRetime(std::string_view text);
/// What parseRetime() reads.
[[nodiscard]] std::string textOfRetime(const Curve& retime);

/// Frame that a cell shows.
/// @param cell 0 at the top left, counted along rows
[[nodiscard]] int frameOfCell(const FlipbookOptions& options, int cell);

/// Those of all cells.
[[nodiscard]] std::vector<int> framesOfCells(const FlipbookOptions& options);
/// The same, and whether the first comes again after the last.
[[nodiscard]] CellFrames cellFramesOf(const Scene& scene, const FlipbookOptions& options);

/// Cells that are to be shown in a second, so that the effect keeps its speed.
[[nodiscard]] double cellsPerSecond(const Scene& scene, const FlipbookOptions& options);

} // namespace fumage
