#pragma once

#include "core/base/result.h"

#include <string>

namespace fumage::cli {

/// Does the jobs of a list one after the other, and says what became of each; one that fails does not keep the others
/// from being done.
/// @param file   as writeJobsFile() writes it; "-" is standard input
/// @param asJson answer in JSON on standard output, once all are done
/// @error that of the first job that failed and that trying again cannot mend, or else of the first; Cancelled; before
/// anything is rendered those of readJobsFile() and checkJobs()
[[nodiscard]] Status doJobs(const std::string& file, bool asJson);

} // namespace fumage::cli
