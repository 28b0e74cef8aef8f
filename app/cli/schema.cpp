#include "app/cli/command.h"

#include "core/preset/schema.h"

namespace fumage::cli {

void addSchema(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand("schema", "Print the JSON Schema of presets");
    command->callback([&action] { action = [] { return writeOutput("-", presetSchema()); }; });
}

} // namespace fumage::cli
