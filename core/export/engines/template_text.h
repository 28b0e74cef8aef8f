#pragma once

#include "core/export/engines/engine_files.h"

namespace fumage {

/// What names of files are written into.
enum class TextKind {
    Code, ///< strings between double quotes, as C#, Python, Godot and Protobuf write them
    Markup, ///< XML and HTML
};

/// A template of resources/engines (Mustache) with what a sheet is.
[[nodiscard]] std::string sheetText(std::string_view name, TextKind kind, const EngineSheet& sheet);

/// One that is of a single picture: how it is imported.
[[nodiscard]] std::string importText(std::string_view name, const EnginePicture& picture);

} // namespace fumage
