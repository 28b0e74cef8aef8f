#include "app/cli/number_options.h"

#include "core/base/text.h"

#include <optional>

namespace fumage::cli {

CLI::Option* addWhole(
    CLI::App& command, const std::string& name, int& value, int low, int high, const std::string& help)
{
    const auto isWithin = [low, high](std::int64_t number) { return number >= low && number <= high; };
    const auto take = [&value, name, low, high, isWithin](const std::string& text) {
        const std::optional<std::int64_t> number = parseInteger(text);
        if (!number || !isWithin(*number)) {
            throw CLI::ValidationError(
                name, inQuotes(text) + " is not a number from " + std::to_string(low) + " to " + std::to_string(high));
        }
        value = static_cast<int>(*number);
    };
    return command.add_option_function<std::string>(name, take, help)
        ->type_name("NUMBER")
        ->default_str(isWithin(value) ? std::to_string(value) : "");
}

} // namespace fumage::cli
