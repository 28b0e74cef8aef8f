#pragma once

#include "core/export/plan.h"

namespace fumage {

/// What a picture shows of the preset that it carries; nothing where the preset stands in a file of its own.
struct Shown {
    std::optional<int> frame; ///< the first of a sheet
    std::optional<FlipbookOptions> sheet; ///< how its cells are made
};

[[nodiscard]] Shown shownBy(const PresetReading& reading);

/// The frames of an export where nobody names any: what the picture shows that the preset came from, but all of the
/// timeline for what moves; else the whole timeline. Of a sheet numbered pictures are those of its cells' range.
[[nodiscard]] FrameRange framesOf(ExportKind kind, const Timeline& timeline, const Shown& shown);

/// Makes a plan one for a sheet again: its cells, passes, packed pictures, sheets of layers, and engine. Output, format
/// and size stay.
void takeSheet(const FlipbookOptions& sheet, ExportPlan& plan);

} // namespace fumage
