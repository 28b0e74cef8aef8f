#include "app/cli/export_arguments.h"

#include "core/base/text.h"

#include <cstdint>

namespace fumage::cli {

namespace {

/// What the library says of a text that is no number within the range; empty: it is one.
std::string complaintOf(const ExportOption& option, const std::string& text)
{
    ExportPlan any;
    const auto bound = [](double value) { return formatFloat(static_cast<float>(value)); };
    return option.read(text, any)
        ? std::string()
        : inQuotes(text) + " is not a number from " + bound(option.low) + " to " + bound(option.high);
}

CLI::Option* addList(CLI::App& command, const ExportOption& option, std::vector<std::string>& texts)
{
    return command.add_option(flagOf(option), texts, std::string(option.help))
        ->type_name(std::string(option.type))
        ->take_all()
        ->allow_extra_args(false)
        ->option_text(std::string(option.type));
}

} // namespace

CLI::Option* ExportArguments::addTo(
    CLI::App& command, std::string_view key, const std::string& help, const std::string& initial)
{
    const ExportOption& option = exportOption(key);
    std::vector<std::string>& texts = m_texts[std::string(key)];
    if (option.form == OptionForm::List) {
        return addList(command, option, texts);
    }
    texts.push_back(initial.empty() ? std::string(option.initial) : initial);
    const std::string said = help.empty() ? std::string(option.help) : help;
    if (option.form == OptionForm::Flag) {
        return command.add_flag_function(
            flagOf(option), [&texts](std::int64_t count) { texts.front() = count > 0 ? "true" : "false"; }, said);
    }
    CLI::Option* added = command.add_option(flagOf(option), texts.front(), said);
    if (option.form == OptionForm::Whole || option.form == OptionForm::Number) {
        added->type_name("NUMBER")->check(
            CLI::Validator([&option](const std::string& text) { return complaintOf(option, text); }, ""));
    } else if (!option.type.empty()) {
        added->type_name(std::string(option.type));
    }
    if (option.form == OptionForm::Points) {
        added->option_text(std::string(option.type));
    }
    if (option.choices != nullptr) {
        added->check(CLI::IsMember(option.choices()));
    }
    return texts.front().empty() ? added : added->capture_default_str();
}

void ExportArguments::addAllTo(CLI::App& command, ExportKind kind)
{
    ExportPlan plan;
    plan.kind = kind;
    for (const ExportOption& option : exportOptions()) {
        if (option.applies(plan) && !option.help.empty() && !m_texts.contains(option.key)) {
            addTo(command, option.key);
        }
    }
}

void ExportArguments::addTargetsTo(CLI::App& command)
{
    addTo(command, "passes",
        "Layers of an EXR, with commas between: colour, alpha, density, six-way (light from six sides), motion "
        "(vectors), normal, depth, emission, albedo, temperature, shadow, all; layer-masks (a channel a layer, which "
        "add up to alpha). Default: colour");
    addTo(command, "alpha",
        "Light, emission and albedo: premultiplied (the default), or straight; the colour is premultiplied, as "
        "readers of EXR expect it");
}

std::string_view ExportArguments::textOf(std::string_view key) const
{
    const auto found = m_texts.find(key);
    return found == m_texts.end() || found->second.empty() ? std::string_view() : found->second.back();
}

bool ExportArguments::isForAnEngine() const
{
    return has("engine") && textOf("engine") != nameOf(Engine::Generic);
}

Status ExportArguments::applyTo(ExportPlan& plan) const
{
    if (m_texts.contains("passes")) { // frames have no engine that would choose for them
        plan.passes = passesFor(plan.flipbook.engine);
        plan.style = styleFor(plan.flipbook.engine, plan.format);
    }
    for (const ExportOption& option : exportOptions()) {
        const auto found = m_texts.find(option.key);
        if (found == m_texts.end()) {
            continue;
        }
        for (const std::string& text : found->second) {
            if (Status status = text.empty() ? Status(Done{}) : option.read(text, plan); !status) {
                Error error = status.error();
                error.place = flagOf(option);
                return error;
            }
        }
    }
    return Done{};
}

} // namespace fumage::cli
