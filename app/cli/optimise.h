#pragma once

#include "app/cli/picture_options.h"

#include "core/export/sheets/sheet_optimizer.h"

namespace fumage::cli {

/// Reads "4MB", "512 KB" or "1.5MiB"; M is 1024 K, and K 1024 bytes.
/// @error OutOfRange
[[nodiscard]] Result<std::int64_t> parseBudget(const std::string& text);

/// Tries the sheets that fit into a budget, prints how well each plays, and says which is best.
/// @error those of parseBudget() and rateSheets()
[[nodiscard]] Result<SheetCandidate> chooseSheet(const PictureJob& job, const std::string& budget);

} // namespace fumage::cli
