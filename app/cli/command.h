#pragma once

#include "app/cli/interruption.h"
#include "app/cli/streams.h"

#include "core/base/result.h"
#include "core/effect/effect.h"
#include "core/export/shown.h"
#include "core/preset/library.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace fumage::cli {

/// What the program exits with; documented in its help and the README.
enum ExitCode {
    kSuccess = 0,
    kFailure = 1,
    kUsage = 2,
    kBadInput = 3,
    kMismatch = 4,
    kTryAgain = 75, ///< as EX_TEMPFAIL of sysexits.h
    kInterrupted = 130,
};

/// What the program exits with where this is all that was done.
[[nodiscard]] ExitCode exitCodeOf(ErrorCode code);

/// The action of the chosen subcommand; set while the command line is read, run after it.
using Action = std::function<Status()>;

/// A preset with the changes of the command line.
struct NamedPreset {
    Preset preset;
    std::string name; ///< files are named after it where the user does not say how
    std::filesystem::path file; ///< of the preset; empty where it is built in or came from standard input
    Shown shown; ///< by the picture that it was read from
};

/// Effects as the command line names them: presets, then changes to them.
struct EffectOptions {
    std::vector<std::string> presets;
    std::vector<std::string> assignments;
    std::vector<std::string> animations;
    std::vector<std::string> markers;
    std::optional<std::string> layers; ///< to be shown, all others muted; none: those that the preset shows
    std::optional<std::string> muted;

    /// Adds PRESET, --set, --animate, --marker, --layers and --mute to a subcommand.
    void addTo(CLI::App& command);

    /// Loads all presets, applies --set, then --animate, then --marker in order, shows and mutes layers, then does the
    /// work for each; warnings go to standard error.
    /// @param output what the user named for what is written: with several presets only a folder will do
    [[nodiscard]] Status forEach(
        const std::string& output, const std::function<Status(const NamedPreset&)>& work) const;
    /// The same for work that writes no files.
    [[nodiscard]] Status forEach(const std::function<Status(const NamedPreset&)>& work) const;

private:
    [[nodiscard]] Result<std::vector<NamedPreset>> loadAll() const;
};

/// Adds --json to a subcommand whose answer a program may want to read.
void addJson(CLI::App& command, bool& asJson);

/// The frames that somebody asks for with --frames.
/// @param asked empty: those of framesOf()
/// @error that of parseFrameRange()
[[nodiscard]] Result<FrameRange> framesFor(const std::string& asked, const NamedPreset& named, ExportKind kind);
/// The same for what is of one frame by default.
/// @param asked empty: the frame of the picture that the preset was read from, else 0
[[nodiscard]] Result<FrameRange> oneFrameFor(const std::string& asked, const NamedPreset& named);
/// What the help says of them.
inline constexpr const char* kFramesHelp = "Frames: 7, 0-119 or 0-119:2. Default: the whole timeline";
inline constexpr const char* kOneFrameHelp =
    "Frames: 7, 0-119 or 0-119:2. Default: 0, or of a picture that carries its preset the one that it shows";

/// Reads a preset that a person names; "-" is standard input.
[[nodiscard]] Result<PresetReading> readPreset(const std::string& name);

// One function a subcommand: adds it to the program and sets the action when it is chosen.
void addRender(CLI::App& program, Action& action);
void addFlipbook(CLI::App& program, Action& action);
void addVideo(CLI::App& program, Action& action);
void addVolume(CLI::App& program, Action& action);
void addCheckSheet(CLI::App& program, Action& action);
void addFit(CLI::App& program, Action& action);
void addBakeNoise(CLI::App& program, Action& action);
void addAir(CLI::App& program, Action& action);
void addDump(CLI::App& program, Action& action);
void addJoin(CLI::App& program, Action& action);
void addFarm(CLI::App& program, Action& action);
void addVerify(CLI::App& program, Action& action);
void addValidate(CLI::App& program, Action& action);
void addInfo(CLI::App& program, Action& action);
void addPresets(CLI::App& program, Action& action);
void addParameters(CLI::App& program, Action& action);
void addSchema(CLI::App& program, Action& action);
void addCompletions(CLI::App& program, Action& action);

} // namespace fumage::cli
