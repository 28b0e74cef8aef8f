#pragma once

#include "core/export/export_option.h"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fumage {

/// All options of exports, in the order in which they are written and read: later ones may look at those before. The
/// engine sets passes, signs and channels, which those that follow change.
[[nodiscard]] std::span<const ExportOption> exportOptions();

/// @param key of one that there is
[[nodiscard]] const ExportOption& exportOption(std::string_view key);

/// "--power-of-two"
[[nodiscard]] std::string flagOf(const ExportOption& option);

/// The texts of a list that are one text.
[[nodiscard]] std::vector<std::string> splitList(std::string_view text);

/// What manifests say of a plan.
[[nodiscard]] std::map<std::string, std::string> settingsOf(const ExportPlan& plan);
/// Reads them again.
/// @param plan with its kind and its format
/// @error WrongType where one is missing; that of the first that is not understood
[[nodiscard]] Status readSettings(const std::map<std::string, std::string>& settings, ExportPlan& plan);

} // namespace fumage
