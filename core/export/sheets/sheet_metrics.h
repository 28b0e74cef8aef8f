#pragma once

#include "core/export/export_task.h"
#include "core/export/sheets/flipbook.h"
#include "core/scene/scene.h"

#include <optional>

namespace fumage {

/// How well a flipbook's passes do what engines use them for. Decibels are peak signal to noise ratios against a peak
/// of 1.
struct SheetScore {
    /// Pictures that engines make of the two maps of six-way light, against smoke that is rendered under that light.
    struct SixWay {
        double decibels = 0.0; ///< of all directions and cells together
        double worst = 0.0; ///< of the worst direction
        float scale = 1.0F; ///< of the maps
    } sixWay;
    /// Pictures between two cells, against the frames that are there.
    struct Motion {
        double rebuilt = 0.0; ///< from the vectors
        double crossFaded = 0.0; ///< without them
        float scale = 1.0F; ///< of the vectors
        int between = 0; ///< how many pictures were looked at
    } motion;
    float edgeAlpha = 0.0F; ///< most alpha on a cell's border
    double clipped = 0.0; ///< share of the pixels with smoke whose colour is brighter than the view transform can show
    int empty = 0; ///< cells without smoke
};

/// Measures a flipbook with what its files would hold.
///
/// Six-way light, after Unity's SixWayLighting: with d the direction to the light in the picture's frame, T is the sum
/// of d_i^2 times the map of that side of the axis; compared with the smoke under that light, premultiplied, for 20
/// directions spread evenly over the sphere, in `lit` cells. Motion, after Unity's VFXCommonOutput: with f the way from
/// one cell to the next, s0 = colour_i(uv - m_i(uv) f), s1 = colour_i+1(uv + m_i+1(uv) (1 - f)), their mixture by f;
/// compared with the frame in the middle, as is the mixture without m. Colours are linear, premultiplied and at most 1.
/// @param options the pictures' format decides how finely maps and vectors are told apart
/// @param lit     cells that six-way light is measured in, spread evenly; 1 or more
/// @error those of renderFlipbook(); OutOfRange where no frame lies between two cells
/// O(cells + 20 lit). For tests and for those who choose a grid.
[[nodiscard]] Result<SheetScore> scoreSheet(
    const Scene& scene, const FlipbookOptions& options, int lit, const ExportTask& task = {});

} // namespace fumage
