#pragma once

#include "core/export/plan.h"

#include <string>

#include <CLI/CLI.hpp>

namespace fumage::cli {

/// How videos are played: what the commands that write them have in common.
struct PlayingOptions {
    std::string rate;
    std::string repeat{nameOf(Repeat::Auto)};

    void addTo(CLI::App& command);
    /// @error that of parseFrameRate()
    [[nodiscard]] Status applyTo(ExportPlan& plan) const;
};

} // namespace fumage::cli
