#include "app/cli/optimise.h"

#include "app/cli/progress.h"

#include "core/base/text.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace fumage::cli {

namespace {

constexpr double kKilo = 1024.0;

std::string table(const std::vector<SheetCandidate>& candidates, const SheetCandidate& best)
{
    std::ostringstream text;
    text << "  grid       cell      BC7 MB      dB\n";
    for (const SheetCandidate& each : candidates) {
        const std::string grid = std::to_string(each.columns) + "x" + std::to_string(each.rows);
        const std::string cell = std::to_string(each.width) + "x" + std::to_string(each.height);
        text << (&each == &best ? "* " : "  ") << std::left << std::setw(8) << grid << std::right << std::setw(9)
             << cell << std::fixed << std::setprecision(2) << std::setw(10)
             << static_cast<double>(each.bytes) / kKilo / kKilo << std::setprecision(1) << std::setw(10)
             << each.decibels << "\n";
    }
    return text.str();
}

} // namespace

Result<std::int64_t> parseBudget(const std::string& text)
{
    const std::size_t digits = std::min(text.find_first_not_of("0123456789."), text.size());
    const std::string unit = inSmallLetters(trimmed(std::string_view(text).substr(digits)));
    const std::optional<float> number = parseFloat(std::string_view(text).substr(0, digits));
    double bytes = number ? static_cast<double>(*number) : 0.0;
    if (unit == "mb" || unit == "mib") {
        bytes *= kKilo * kKilo;
    } else if (unit == "kb" || unit == "kib") {
        bytes *= kKilo;
    } else {
        bytes = 0.0;
    }
    constexpr double kMax = kKilo * kKilo * kKilo * kKilo;
    if (!(bytes >= 1.0 && bytes <= kMax)) {
        return Error{ErrorCode::OutOfRange, makeMessage("the budget %1 is not understood", inQuotes(text)),
            std::string("--optimise"), makeMessage("Write 4MB or 512KB")};
    }
    return static_cast<std::int64_t>(bytes);
}

Result<SheetCandidate> chooseSheet(const PictureJob& job, const std::string& budget)
{
    const Result<std::int64_t> bytes = parseBudget(budget);
    if (!bytes) {
        return bytes.error();
    }
    Result<std::vector<SheetCandidate>> rated = std::vector<SheetCandidate>();
    {
        ProgressBar bar("Trying sheets");
        rated = rateSheets(job.scene, job.plan, bytes.value(), bar.task());
    }
    if (!rated) {
        return rated.error();
    }
    const SheetCandidate& best = bestOf(rated.value());
    const Status status = print(table(rated.value(), best));
    return status ? Result<SheetCandidate>(best) : status.error();
}

} // namespace fumage::cli
