#pragma once

#include "core/base/message.h"
#include "core/export/sheets/flipbook_options.h"
#include "core/scene/scene.h"

#include <vector>

namespace fumage {

/// Cells a second that an engine shows of a sheet that is meant to have some other number: Effekseer counts a cell in
/// whole sixtieths of a second, and Defold in whole cells a second. All others keep it.
/// @param cellsPerSecond more than 0
[[nodiscard]] double playedRate(Engine engine, double cellsPerSecond);

/// What an artist should know before an engine plays a sheet in another way than it is made: a speed that it cannot
/// keep within 2 %, with what it could keep, and a grid that it is said to misread. Empty: nothing. O(1).
[[nodiscard]] std::vector<Message> engineRemarks(const Scene& scene, const FlipbookOptions& options);

} // namespace fumage
