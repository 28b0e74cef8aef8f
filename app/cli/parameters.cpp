#include "app/cli/command.h"

#include "core/base/text.h"
#include "core/effect/parameter_table.h"
#include "core/effect/value.h"

#include <memory>
#include <sstream>

namespace fumage::cli {

namespace {

std::string rangeText(const Parameter& parameter)
{
    if (parameter.kind == Kind::Choice) {
        std::string all;
        for (const std::string_view choice : parameter.choices) {
            all += (all.empty() ? "" : ", ") + std::string(choice);
        }
        return all;
    }
    if (parameter.kind == Kind::Bool) {
        return "true, false";
    }
    if (parameter.kind == Kind::Seed) {
        return "0 to 4294967295";
    }
    return formatFloat(static_cast<float>(parameter.hard.low)) + " to " + formatFloat(static_cast<float>(parameter.hard.high));
}

Status plain()
{
    const Effect defaults;
    std::ostringstream out;
    for (const Parameter& parameter : parameterTable()) {
        out << parameter.key << " = " << formatText(parameter, parameter.get(defaults), true) << "  (" << rangeText(parameter) << ")\n    " << parameter.tip << "\n";
    }
    return print(out.str());
}

Status markdown()
{
    const Effect defaults;
    std::ostringstream out;
    std::string_view group;
    out << "# Parameters\n\nWritten by `fumage-cli parameters --markdown`.\n";
    for (const Parameter& parameter : parameterTable()) {
        if (parameter.group() != group) {
            group = parameter.group();
            out << "\n## " << groupLabel(group) << "\n\n| key | default | range | unit | what it does |\n|---|---|---|---|---|\n";
        }
        out << "| <a id=\"" << parameter.key << "\"></a>`" << parameter.key << "` | " << formatText(parameter, parameter.get(defaults)) << " | " << rangeText(parameter) << " | "
            << unitSymbol(parameter.unit) << " | " << parameter.tip << (parameter.source.empty() ? "" : " *" + std::string(parameter.source) + ".*") << " |\n";
    }
    return print(out.str());
}

} // namespace

void addParameters(CLI::App& program, Action& action)
{
    auto asMarkdown = std::make_shared<bool>(false);
    CLI::App* command = program.add_subcommand("parameters", "List all parameters with defaults, ranges and what they do");
    command->add_flag("--markdown", *asMarkdown, "As tables for documentation");
    command->callback([asMarkdown, &action] { action = [asMarkdown] { return *asMarkdown ? markdown() : plain(); }; });
}

} // namespace fumage::cli
