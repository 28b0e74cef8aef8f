#pragma once

#include "core/base/result.h"
#include "core/export/export_plan.h"

#include <map>
#include <string>

namespace fumage {

/// What manifests say of a plan.
[[nodiscard]] std::map<std::string, std::string> settingsOf(const ExportPlan& plan);
/// Reads them again.
/// @param plan with its kind and its format
/// @error WrongType where one is missing; that of the first that is not understood
[[nodiscard]] Status readSettings(const std::map<std::string, std::string>& settings, ExportPlan& plan);

} // namespace fumage
