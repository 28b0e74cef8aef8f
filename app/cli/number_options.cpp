#include "app/cli/number_options.h"

#include "core/base/text.h"

#include <optional>

namespace fumage::cli {

namespace {

/// @param parse gives the number of a text, if it is one that is allowed
template <class Number, class Parse>
CLI::Option* addParsed(CLI::App& command, const std::string& name, Number& value, const std::string& range,
    const std::string& help, const std::string& defaultText, const Parse& parse)
{
    const auto take = [&value, name, range, parse](const std::string& text) {
        const std::optional<Number> number = parse(text);
        if (!number) {
            throw CLI::ValidationError(name, inQuotes(text) + " is not a number " + range);
        }
        value = *number;
    };
    return command.add_option_function<std::string>(name, take, help)
        ->type_name("NUMBER")
        ->default_str(parse(defaultText) ? defaultText : "");
}

} // namespace

CLI::Option* addWhole(
    CLI::App& command, const std::string& name, int& value, int low, int high, const std::string& help)
{
    const std::string range = "from " + std::to_string(low) + " to " + std::to_string(high);
    return addParsed(command, name, value, range, help, std::to_string(value), [low, high](const std::string& text) {
        const std::optional<std::int64_t> number = parseInteger(text);
        return number && *number >= low && *number <= high ? std::optional(static_cast<int>(*number)) : std::nullopt;
    });
}

CLI::Option* addNumber(
    CLI::App& command, const std::string& name, float& value, float low, float high, const std::string& help)
{
    const std::string range = "from " + formatFloat(low) + " to " + formatFloat(high);
    return addParsed(command, name, value, range, help, formatFloat(value), [low, high](const std::string& text) {
        const std::optional<float> number = parseFloat(text);
        return number && *number >= low && *number <= high ? number : std::nullopt;
    });
}

} // namespace fumage::cli
