#pragma once

#include "app/cli/command.h"

#include "core/export/export_option_table.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace fumage::cli {

/// Options of exports on the command line of one command, as the table of them has them.
class ExportArguments {
public:
    /// @param key     of the table
    /// @param help    in place of the table's, where the command means it in a way of its own
    /// @param initial in place of the table's; empty: that one
    CLI::Option* addTo(
        CLI::App& command, std::string_view key, const std::string& help = {}, const std::string& initial = {});
    /// All that exports of a kind ask for and that are not there yet.
    void addAllTo(CLI::App& command, ExportKind kind);
    /// The passes of frames, which are targets.
    void addTargetsTo(CLI::App& command);

    /// Whether somebody has said it.
    [[nodiscard]] bool has(std::string_view key) const { return !textOf(key).empty(); }
    /// What was said, or is where nobody says otherwise; of a list, the last.
    [[nodiscard]] std::string_view textOf(std::string_view key) const;
    /// Whether somebody has said what is to play it.
    [[nodiscard]] bool isForAnEngine() const;

    /// @param plan with its kind and its format
    /// @error that of the first option that is not understood, with its name
    [[nodiscard]] Status applyTo(ExportPlan& plan) const;

private:
    std::map<std::string, std::vector<std::string>, std::less<>> m_texts;
};

} // namespace fumage::cli
