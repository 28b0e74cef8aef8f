#pragma once

#include "core/export/sheets/flipbook_options.h"
#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace fumage {

/// A marker as the one who plays a sheet passes it.
struct SheetEvent {
    std::string name;
    double seconds = 0.0; ///< since the first cell, at the speed of cellsPerSecond()
    int cell = 0; ///< that is shown then, counted as in frameOfCell()
    friend bool operator==(const SheetEvent&, const SheetEvent&) = default;
};

/// The markers of a scene that a sheet passes, in the order in which it does. Between one cell and the next, time goes
/// evenly from the frame of the one to that of the other, so that an event comes when cells are blended, too: with
/// frames a and b of cells c and c + 1, a marker at frame f comes at cell c + (f - a) / (b - a). In a timeline that
/// loops a marker is passed once a turn, and once a cell at most; a curve that goes back and forth passes it the first
/// time only. Those that lie outside of the frames are left out. O(markers * cells).
[[nodiscard]] std::vector<SheetEvent> sheetEvents(const Scene& scene, const FlipbookOptions& options);

/// The markers of a scene that a sheet does not pass.
/// O(markers * cells).
[[nodiscard]] std::vector<Marker> markersOutside(const Scene& scene, const FlipbookOptions& options);

} // namespace fumage
