#pragma once

#include "core/export/jobs/jobs.h"
#include "core/preset/json_tree.h"

#include <span>

namespace fumage {

/// One line of a job in a file of them: how it is written, and how it is read.
struct JobField {
    std::string_view key;
    /// Its value as JSON; none where the job's kind does not ask for it.
    std::optional<std::string> (*written)(const ExportJob& job);
    /// @param text the whole file
    /// @error without place
    Status (*read)(const JsonNode& value, std::string_view text, ExportJob& job);
};

/// All but the preset, in the order in which they are written and read: later ones may look at those before.
[[nodiscard]] std::span<const JobField> jobFields();

} // namespace fumage
