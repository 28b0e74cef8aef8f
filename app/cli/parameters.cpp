#include "app/cli/command.h"
#include "app/cli/json_answer.h"

#include "core/base/joined.h"
#include "core/base/text.h"
#include "core/effect/parameter_table.h"
#include "core/effect/value.h"
#include "core/preset/preset.h"

#include <memory>
#include <sstream>

namespace fumage::cli {

namespace {

std::string rangeText(const Parameter& parameter)
{
    if (parameter.kind == Kind::Choice) {
        return joined(parameter.choices);
    }
    if (parameter.kind == Kind::Bool) {
        return "true, false";
    }
    if (parameter.kind == Kind::Seed) {
        return "0 to 4294967295";
    }
    if (parameter.kind == Kind::Picture) {
        return "PNG, at most " + std::to_string(kMaxPictureEdge) + " px an edge";
    }
    return formatFloat(static_cast<float>(parameter.hard.low)) + " to "
        + formatFloat(static_cast<float>(parameter.hard.high));
}

/// When a parameter with key frames has its value; nothing where it cannot change over time.
std::string_view readingText(Animates animates)
{
    switch (animates) {
    case Animates::Never: return {};
    case Animates::Frame: return "at each frame";
    case Animates::Step: return "at each step";
    case Animates::Birth: return "at birth";
    case Animates::Rate: return "summed up";
    }
    return {};
}

Status plain()
{
    const Effect defaults;
    std::ostringstream out;
    for (const Parameter& parameter : parameterTable()) {
        out << parameter.key << " = " << formatText(parameter, parameter.get(defaults), true) << "  ("
            << rangeText(parameter) << ")\n    " << parameter.tip << "\n";
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
            out << "\n## " << groupLabel(group)
                << "\n\n| key | default | range | unit | key frames | what it does |\n|---|---|---|---|---|---|\n";
        }
        out << "| <a id=\"" << parameter.key << "\"></a>`" << parameter.key << "` | "
            << formatText(parameter, parameter.get(defaults), parameter.kind == Kind::Picture) << " | "
            << rangeText(parameter) << " | " << unitSymbol(parameter.unit) << " | " << readingText(parameter.animates)
            << " | " << parameter.tip << (parameter.source.empty() ? "" : " *" + std::string(parameter.source) + ".*")
            << " |\n";
    }
    return print(out.str());
}

Status json()
{
    const JsonValues defaults(Preset{});
    auto all = nlohmann::ordered_json::array();
    for (const Parameter& parameter : parameterTable()) {
        nlohmann::ordered_json& one = all.emplace_back(
            nlohmann::ordered_json{{"key", parameter.key}, {"label", parameter.label}, {"group", parameter.group()}});
        one["default"] = defaults.of(parameter);
        if (parameter.kind == Kind::Choice) {
            one["choices"] = std::vector<std::string_view>(parameter.choices.begin(), parameter.choices.end());
        } else if (parameter.kind != Kind::Bool && parameter.kind != Kind::Picture) {
            one["minimum"] = parameter.hard.low;
            one["maximum"] = parameter.hard.high;
        }
        one["unit"] = unitSymbol(parameter.unit);
        one["tip"] = parameter.tip;
        one["source"] = parameter.source;
    }
    return printJson(all);
}

struct ParameterOptions {
    bool markdown = false;
    bool json = false;
};

Status run(const ParameterOptions& options)
{
    if (options.json) {
        return json();
    }
    return options.markdown ? markdown() : plain();
}

} // namespace

void addParameters(CLI::App& program, Action& action)
{
    auto options = std::make_shared<ParameterOptions>();
    CLI::App* command =
        program.add_subcommand("parameters", "List all parameters with defaults, ranges and what they do");
    CLI::Option* asMarkdown = command->add_flag("--markdown", options->markdown, "As tables for documentation");
    addJson(*command, options->json);
    command->get_option("--json")->excludes(asMarkdown);
    command->callback([options, &action] { action = [options] { return run(*options); }; });
}

} // namespace fumage::cli
