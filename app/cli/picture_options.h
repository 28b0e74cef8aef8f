#pragma once

#include "app/cli/command.h"
#include "app/cli/export_arguments.h"
#include "app/cli/manifest_option.h"

#include "core/export/plan.h"
#include "core/scene/scene.h"

#include <functional>
#include <optional>

namespace fumage::cli {

/// "640x360", or "512" for both. @return whether it is two numbers from 1 to most
[[nodiscard]] bool parseTwo(const std::string& text, int most, int& first, int& second);

/// What --grid says: columns and rows of a flipbook, or one number for both.
[[nodiscard]] Status parseGrid(const std::string& text, int& columns, int& rows);

/// The same where nobody may have named a grid.
/// @param asked    empty: that of the sheet which carries the preset, or else the usual one
[[nodiscard]] Status gridFor(
    const std::string& asked, const char* usual, const NamedPreset& named, int& columns, int& rows);

/// What pictures are to be rendered.
struct PictureJob {
    Scene scene;
    ExportPlan plan;
};

/// The options that the commands that render have in common.
struct PictureOptions {
    EffectOptions effect;
    std::string output;
    std::string frames;
    std::string size;
    int supersample = 0;
    std::string format;
    bool carriesPreset = true;
    ManifestOption manifest;
    ExportArguments options;

    void addTo(CLI::App& command, const std::string& outputHelp, const std::string& sizeHelp,
        const std::string& framesHelp = kFramesHelp);
    /// Adds what only pictures have.
    void addFormat(CLI::App& command);
    /// What is to be done with one of the presets.
    /// @param kind decides about the frames where none are named; see framesOf()
    [[nodiscard]] Result<PictureJob> jobFor(const NamedPreset& named, ExportKind kind) const;
    /// The same, but for what it is to be written to, and for the options.
    [[nodiscard]] Result<PictureJob> jobWithoutOutput(const NamedPreset& named, ExportKind kind) const;
};

/// Fills in format and path of a plan for pictures.
/// @param output     as the user named it
/// @param formatName png, png16, exr, exr32, tga; empty: by the ending of the output
/// @param name       what the file is called where only a folder is named
[[nodiscard]] Status chooseOutput(
    const std::string& output, const std::string& formatName, const std::string& name, ExportPlan& plan);

/// Says what an export does otherwise than one may expect of it; see remarksOn().
void warnOf(const Scene& scene, const ExportPlan& plan);

/// Does a job with a bar of progress that can be interrupted, and says what was written.
/// @return the flipbook, where that is what was made
[[nodiscard]] Result<std::optional<Flipbook>> writePictures(const PictureJob& job);

/// Runs an export of a scene with a bar of progress, and says what was written and what was there already.
[[nodiscard]] Result<std::optional<Flipbook>> exportWithBar(const Scene& scene, const ExportPlan& plan,
    const std::function<Result<std::optional<Flipbook>>(const Task& task)>& run);

/// The files that an export has written.
struct Written {
    int count;
    std::filesystem::path first;
    std::filesystem::path last;
};

/// @param flipbook what runExport() returned
[[nodiscard]] Written writtenBy(const Scene& scene, const ExportPlan& plan, const std::optional<Flipbook>& flipbook);

} // namespace fumage::cli
