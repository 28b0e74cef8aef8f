#pragma once

#include "core/export/export_option.h"

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

} // namespace fumage
