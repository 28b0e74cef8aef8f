#pragma once

#include "core/base/joined.h"
#include "core/base/text.h"
#include "core/export/export_option.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fumage {

// Get is a lambda without captures that gives the member of a plan, of one that changes or of one that does not.

template <class Enum, std::size_t kCount>
std::vector<std::string> namesOf()
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < kCount; ++i) {
        names.emplace_back(nameOf(static_cast<Enum>(i)));
    }
    return names;
}

inline Error unknownName(std::string_view name, const std::vector<std::string>& all)
{
    return {ErrorCode::UnknownName, makeMessage("%1 is not known here", inQuotes(name)), {},
        makeMessage("Choose from %1", joined(all))};
}

/// Enumerators that are counted from 0.
template <class Enum, std::size_t kCount, class Get>
constexpr ExportOption choiceOption(ExportOption option, Get)
{
    option.choices = namesOf<Enum, kCount>;
    option.text = [](const ExportPlan& plan) -> std::optional<std::string> {
        const std::optional<Enum> value = Get{}(plan);
        return value ? std::optional<std::string>(nameOf(*value)) : std::nullopt;
    };
    option.read = [](std::string_view text, ExportPlan& plan) -> Status {
        const std::optional<Enum> value = enumeratorNamed<Enum, kCount>(text);
        if (!value) {
            return unknownName(text, namesOf<Enum, kCount>());
        }
        Get{}(plan) = *value;
        return Done{};
    };
    return option;
}

/// What a function makes of a text, and textOf() a text of.
template <auto kParse, class Get>
constexpr ExportOption parsedOption(ExportOption option, Get)
{
    option.text = [](const ExportPlan& plan) -> std::optional<std::string> {
        using Parsed = std::decay_t<decltype(kParse(std::string_view()).value())>;
        const std::optional<Parsed> value = Get{}(plan);
        return value ? std::optional<std::string>(textOf(*value)) : std::nullopt;
    };
    option.read = [](std::string_view text, ExportPlan& plan) -> Status {
        auto value = kParse(text);
        if (!value) {
            return value.error();
        }
        Get{}(plan) = std::move(value).value();
        return Done{};
    };
    return option;
}

template <class Get>
constexpr ExportOption flagOption(ExportOption option, Get)
{
    option.form = OptionForm::Flag;
    option.text = [](const ExportPlan& plan) -> std::optional<std::string> { return Get{}(plan) ? "true" : "false"; };
    option.read = [](std::string_view text, ExportPlan& plan) -> Status {
        if (text != "true" && text != "false") {
            return Error{ErrorCode::WrongType, makeMessage("expected true or false"), {}, {}};
        }
        Get{}(plan) = text == "true";
        return Done{};
    };
    return option;
}

template <int kLow, int kHigh, class Get>
constexpr ExportOption wholeOption(ExportOption option, Get)
{
    option.form = OptionForm::Whole;
    option.low = kLow;
    option.high = kHigh;
    option.text = [](const ExportPlan& plan) -> std::optional<std::string> { return std::to_string(Get{}(plan)); };
    option.read = [](std::string_view text, ExportPlan& plan) -> Status {
        const std::optional<std::int64_t> number = parseInteger(text);
        if (!number || *number < kLow || *number > kHigh) {
            return Error{
                ErrorCode::OutOfRange, makeMessage("expected a whole number from %1 to %2", kLow, kHigh), {}, {}};
        }
        Get{}(plan) = static_cast<int>(*number);
        return Done{};
    };
    return option;
}

template <const float& kLow, const float& kHigh, class Get>
constexpr ExportOption numberOption(ExportOption option, Get)
{
    option.form = OptionForm::Number;
    option.low = kLow;
    option.high = kHigh;
    option.text = [](const ExportPlan& plan) -> std::optional<std::string> {
        const std::optional<float> value = Get{}(plan);
        return value ? std::optional<std::string>(formatFloat(*value)) : std::nullopt;
    };
    option.read = [](std::string_view text, ExportPlan& plan) -> Status {
        const std::optional<float> value = parseFloat(text);
        if (!value || !(*value >= kLow && *value <= kHigh)) {
            return Error{ErrorCode::OutOfRange,
                makeMessage("expected a number from %1 to %2", formatFloat(kLow), formatFloat(kHigh)), {}, {}};
        }
        Get{}(plan) = *value;
        return Done{};
    };
    return option;
}

} // namespace fumage
