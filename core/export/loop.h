#pragma once

#include "core/export/sheets/flipbook_options.h"

#include <optional>

namespace fumage {

/// After how many frames what is shown begins again, so that it goes on without a jump: frames are whole turns of a
/// timeline that loops. All that is written of loops (side-cars, files for engines, vectors at the seam, videos that
/// repeat) asks here.
/// @return none: the timeline does not loop, or the frames are not whole turns of it
[[nodiscard]] std::optional<int> turnOf(const Timeline& timeline, const FrameRange& frames);
/// The same of the cells of a flipbook, whose curve, where it has one, must end where it begins: there and back is a
/// turn of no frames.
[[nodiscard]] std::optional<int> turnOf(const Timeline& timeline, const FlipbookOptions& options);

/// The frames that are to be chosen in place of those that do not close a loop: as many turns as come nearest, from the
/// same first frame, with the nearest step that divides a turn.
/// @param fewest how many frames there must be
/// @return none: the timeline does not loop, the frames close, or as many would have numbers beyond kMaxFrame
[[nodiscard]] std::optional<FrameRange> closedInstead(
    const Timeline& timeline, const FrameRange& frames, int fewest = 1);

} // namespace fumage
