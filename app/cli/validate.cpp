#include "app/cli/command.h"

#include "core/base/text.h"
#include "core/preset/library.h"

#include <iostream>
#include <memory>

namespace fumage::cli {

namespace {

struct ValidateOptions {
    std::vector<std::string> presets;
    bool strict = false;
};

Status validate(const ValidateOptions& options)
{
    Status result = Done{};
    for (const std::string& name : options.presets) {
        const Result<PresetReading> reading = readPreset(name);
        if (!reading) {
            std::cerr << "fumage-cli: " << printable(reading.error().text()) << '\n';
            result = Error{reading.error().code, makeMessage("not every preset is valid"), {}, {}};
            continue;
        }
        for (const Message& warning : reading.value().warnings) {
            warn(warning.text());
        }
        if (options.strict && !reading.value().warnings.empty()) {
            result = Error{ErrorCode::OutOfRange, makeMessage("there were warnings"), {},
                makeMessage("Leave out --strict to accept them")};
        } else if (Status status = print(printable(name) + ": valid\n"); !status) {
            return status;
        }
    }
    return result;
}

} // namespace

void addValidate(CLI::App& program, Action& action)
{
    auto options = std::make_shared<ValidateOptions>();
    CLI::App* command = program.add_subcommand("validate", "Check presets and say what is wrong with them");
    command->add_option("presets", options->presets, "Names or files")->required()->type_name("PRESET");
    command->add_flag("--strict", options->strict, "Take warnings as errors");
    command->callback([options, &action] { action = [options] { return validate(*options); }; });
}

} // namespace fumage::cli
