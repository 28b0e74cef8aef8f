#pragma once

#include "core/export/jobs/jobs.h"
#include "core/preset/json_tree.h"

#include <span>

namespace fumage {

/// Keys of all lines of a job but the preset, in the order in which they are written and read: later ones may look at
/// those before.
[[nodiscard]] std::span<const std::string_view> jobKeys();

/// The value of a line as JSON; none where the job's kind does not ask for it.
/// @param key of one of jobKeys()
[[nodiscard]] std::optional<std::string> writtenField(std::string_view key, const ExportJob& job);

/// @param text the whole file
/// @error without place
[[nodiscard]] Status readField(std::string_view key, const JsonNode& value, std::string_view text, ExportJob& job);

} // namespace fumage
