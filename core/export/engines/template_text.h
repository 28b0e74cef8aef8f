#pragma once

#include "core/export/engines/engine_sheet.h"
#include "core/export/templates/language.h"

namespace fumage {

/// The language of a template of resources/engines. Each must be told here.
[[nodiscard]] Language languageOfTemplate(std::string_view name);

/// A template of resources/engines (Mustache) with what a sheet is.
[[nodiscard]] std::string sheetText(std::string_view name, const EngineSheet& sheet);

/// One that is of a single picture: how it is imported.
[[nodiscard]] std::string importText(std::string_view name, const EnginePicture& picture);

} // namespace fumage
