#pragma once

#include "core/base/result.h"
#include "core/export/sequence.h"

#include <filesystem>
#include <string>
#include <vector>

namespace fumage {
class JobFiles;
struct ExportPlan;
} // namespace fumage

namespace fumage::cli {

/// The files of all frames, in their order.
[[nodiscard]] std::vector<std::filesystem::path> pathsOf(const NumberedFiles& files);

/// Takes the files of a preset in among those that the command writes, before they are written.
/// @param written those of the presets before
/// @error WouldOverwrite where one of these writes the same: "fire" its fire_motion.png, and "fire_motion" its colour;
/// that of JobFiles
[[nodiscard]] Status keepApart(
    const std::string& preset, const Scene& scene, const ExportPlan& plan, JobFiles& written);

/// The same of files that are numbered by their frames.
/// @param manifest that they are written with; empty: none
[[nodiscard]] Status keepApart(
    const std::string& preset, const NumberedFiles& files, const std::filesystem::path& manifest, JobFiles& written);

} // namespace fumage::cli
