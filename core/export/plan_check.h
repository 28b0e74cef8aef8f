#pragma once

#include "core/export/manifest/verify.h"
#include "core/export/plan.h"

namespace fumage {

/// Holds the files of a plan for a scene that has been carried out against the manifest that was written with them.
/// @return what the manifest names, and the files of the plan that it does not name as FileState::Extra: another export
/// of that name has replaced it
/// @error  FileNotFound where there is no manifest; those of openManifests() and checkFiles(); OutOfMemory
[[nodiscard]] Result<std::vector<CheckedFile>> checkExport(
    const Scene& scene, const ExportPlan& plan, const Task& task = {});

} // namespace fumage
