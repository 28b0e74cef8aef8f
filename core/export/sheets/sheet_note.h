#pragma once

#include "core/export/sheets/flipbook_options.h"

#include <optional>
#include <string>
#include <string_view>

namespace fumage {

/// How the cells of a sheet are made, for the notes of its pictures: the settings of its manifest as JSON, but for its
/// name.
[[nodiscard]] std::string sheetNoteOf(const FlipbookOptions& options);

/// Reads sheetNoteOf(), which anybody may have written.
/// @return the flipbook without an output and a preset; nothing where the note is empty or not understood
[[nodiscard]] std::optional<FlipbookOptions> readSheetNote(const std::string& note);

} // namespace fumage
