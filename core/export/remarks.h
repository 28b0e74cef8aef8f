#pragma once

#include "core/export/plan.h"
#include "core/scene/scene.h"

#include <vector>

namespace fumage {

/// What an export does otherwise than one may expect of it, to be said before it begins: loops that its frames do not
/// close, with those that would; pictures of a GIF that are left out; edges that are made even; what an engine makes
/// otherwise of a sheet (engineRemarks()); markers that no sheet passes; presets that are too long to be carried along.
/// @param effect whose output has the size that is asked for
/// O(1), O(markers * cells) of flipbooks, and O(preset) where layers have pictures.
[[nodiscard]] std::vector<Message> remarksOn(const Scene& scene, const ExportPlan& plan);

} // namespace fumage
