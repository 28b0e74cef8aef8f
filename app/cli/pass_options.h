#pragma once

#include "app/cli/command.h"

#include "core/export/plan.h"

namespace fumage::cli {

/// The options that say which passes are written, and how.
struct PassOptions {
    std::string engine = "generic";
    std::string passes; ///< empty, as the others: what the engine takes
    std::string layout;
    std::string vectors;
    std::string normals;
    std::string alpha;
    std::vector<std::string> packs;

    /// Those of flipbooks.
    void addTo(CLI::App& command);
    /// Adds what only flipbooks have: pictures that are packed.
    void addPackTo(CLI::App& command);
    /// Those of frames, whose passes are targets.
    void addTargetsTo(CLI::App& command);
    /// Whether somebody has said what is to play it.
    [[nodiscard]] bool isForAnEngine() const { return engine != nameOf(Engine::Generic); }
    /// @error UnknownName where a pass is not known
    [[nodiscard]] Status applyTo(ExportPlan& plan) const;
};

} // namespace fumage::cli
