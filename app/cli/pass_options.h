#pragma once

#include "app/cli/command.h"

#include "core/export/plan.h"

namespace fumage::cli {

/// The options that say which passes are written, and how.
struct PassOptions {
    std::string passes = "colour";
    std::string layout = "unity";
    std::string vectors = "unity";
    std::string alpha;

    void addTo(CLI::App& command);
    /// @error UnknownName where a pass is not known
    [[nodiscard]] Status applyTo(ExportPlan& plan) const;
};

/// Reads "colour,six-way,motion"; "six-way" is both maps, "all" all there are.
/// @error UnknownName
[[nodiscard]] Result<PassSet> parsePasses(const std::string& text);

} // namespace fumage::cli
