#pragma once

#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>

namespace fumage::cli {

/// --manifest of commands that write files.
struct ManifestOption {
    std::string text; ///< as CLI11 hands out a flag with a value: "true" where no file is named

    void addTo(CLI::App& command);
    /// The manifest that is asked for; empty: none.
    /// @param output that the files are named after
    [[nodiscard]] std::filesystem::path fileFor(const std::filesystem::path& output) const;
};

} // namespace fumage::cli
