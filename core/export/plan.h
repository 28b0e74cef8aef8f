#pragma once

#include "core/export/export_task.h"
#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/export/export_plan.h"
#include "core/export/sheets/flipbook.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace fumage {

/// All files that a plan writes of a scene, in their order; what describes a flipbook, and what its engine needs, among
/// them. O(files).
[[nodiscard]] std::vector<std::filesystem::path> filesOf(const Scene& scene, const ExportPlan& plan);
/// The files of a plan, first and last; what describes a flipbook lies beside it.
[[nodiscard]] std::filesystem::path firstFile(const Scene& scene, const ExportPlan& plan);
[[nodiscard]] std::filesystem::path lastFile(const Scene& scene, const ExportPlan& plan);
/// The manifest, or the part of one, that a plan writes beside its files; empty: none. What is there already is
/// replaced with them.
[[nodiscard]] std::filesystem::path manifestOf(const ExportPlan& plan);

/// The output of an effect with the size of the pictures, or cells, of a plan: for powers of two the nearest, by their
/// ratio.
/// @error OutOfRange where columns and rows make that impossible
[[nodiscard]] Result<Output> outputFor(const Scene& scene, const ExportPlan& plan);

/// The effect as the camera of a plan sees it, which is fitted where that is asked for.
/// @error those of fitCamera() and outputFor()
[[nodiscard]] Result<Scene> sceneSeenBy(const Scene& scene, const ExportPlan& plan, const ExportTask& task = {});

/// The flipbook of a plan with the frames that it is made of: those without smoke at the beginning and the end are left
/// out where that is asked for.
/// @param seen sceneSeenBy()
/// @error those of trimmed()
[[nodiscard]] Result<FlipbookOptions> flipbookSeenBy(
    const Scene& seen, const ExportPlan& plan, const ExportTask& task = {});

/// Writes all that a plan says, each file whole or not at all. On the calling thread.
/// @param task hears of each picture of a sequence and each cell of a flipbook; before them, of each frame that a fit
/// of the camera looked at
/// @return     the flipbook, where that is what was made
/// @error      WouldOverwrite where a file that the plan names is the source; those of fitCamera(), renderSequence(),
/// renderFlipbook(), bakeNoise(), dumpSequence(), writeVolumes(), writeAir(), writeFileAtomically(), and OutOfMemory
[[nodiscard]] Result<std::optional<Flipbook>> runExport(
    const Scene& scene, const ExportPlan& plan, const ExportTask& task = {});

/// The bytes of the one file of a plan, without writing it.
/// @error OutOfRange where there are several files; those of runExport()
[[nodiscard]] Result<std::vector<std::byte>> exportBytes(
    const Scene& scene, const ExportPlan& plan, const ExportTask& task = {});

} // namespace fumage
