#pragma once

#include "core/base/result.h"
#include "core/effect/effect.h"

#include <functional>
#include <stop_token>
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
    kInterrupted = 130
};

/// The action of the chosen subcommand; set while the command line is read, run after it.
using Action = std::function<Status()>;

/// An effect as the command line names it: a preset, then changes to it.
struct EffectOptions {
    std::string preset;
    std::vector<std::string> assignments;

    /// Adds PRESET and --set to a subcommand.
    void addTo(CLI::App& command);

    /// Loads the preset and applies --set in order; warnings go to standard error.
    [[nodiscard]] Result<Effect> load() const;
};

/// A token that stops when the user presses Ctrl-C or the program is asked to end.
[[nodiscard]] std::stop_token interruption();

/// Prints "fumage-cli: warning: ..." to standard error.
void warn(const std::string& text);

/// Writes to a file, or to standard output for "-".
[[nodiscard]] Status writeOutput(const std::string& path, const std::string& text);

// One function a subcommand: adds it to the program and sets the action when it is chosen.
void addRender(CLI::App& program, Action& action);
void addFlipbook(CLI::App& program, Action& action);
void addBakeNoise(CLI::App& program, Action& action);
void addDump(CLI::App& program, Action& action);
void addValidate(CLI::App& program, Action& action);
void addInfo(CLI::App& program, Action& action);
void addPresets(CLI::App& program, Action& action);
void addParameters(CLI::App& program, Action& action);
void addSchema(CLI::App& program, Action& action);
void addCompletions(CLI::App& program, Action& action);

} // namespace fumage::cli
