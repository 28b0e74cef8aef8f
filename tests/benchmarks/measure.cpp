#include "tests/benchmarks/measure.h"

#include "core/base/simd.h"

#include <cstdio>
#include <map>

namespace fumage::benchmarks {

namespace {

/// Prints as usual and remembers the median or only run of each benchmark.
class RememberingReporter : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override
    {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs) {
            if (!run.error_occurred && (run.run_type == Run::RT_Iteration || run.aggregate_name == "median")) {
                m_runs[run.run_name.function_name + (run.run_name.args.empty() ? "" : "/" + run.run_name.args)] = run;
            }
        }
    }

    [[nodiscard]] const Run* find(const std::string& name) const
    {
        const auto found = m_runs.find(name);
        return found == m_runs.end() ? nullptr : &found->second;
    }

private:
    std::map<std::string, Run> m_runs;
};

constexpr double kMillisecondsASecond = 1e3;

double milliseconds(const benchmark::BenchmarkReporter::Run& run)
{
    return run.GetAdjustedRealTime() / benchmark::GetTimeUnitMultiplier(run.time_unit) * kMillisecondsASecond;
}

void print(const RememberingReporter& reporter, const Claim& claim)
{
    const auto* run = reporter.find(claim.benchmark);
    const auto* baseline = claim.baseline.empty() ? nullptr : reporter.find(claim.baseline);
    if (run == nullptr || (!claim.baseline.empty() && baseline == nullptr)) {
        return;
    }
    double figure = milliseconds(*run);
    std::string unit = "ms";
    if (baseline != nullptr) {
        figure = milliseconds(*baseline) / figure;
        unit = "x";
    } else if (!claim.counter.empty()) {
        figure = run->counters.at(claim.counter).value;
        unit = claim.counter;
    }
    const bool reached = claim.atMost ? figure <= claim.target : figure >= claim.target;
    std::printf("%-66s %10.2f %-14s", claim.what.c_str(), figure, unit.c_str());
    if (claim.target > 0.0) {
        std::printf(
            " %s %-8.6g %s", claim.atMost ? "at most " : "at least", claim.target, reached ? "reached" : "MISSED");
    }
    std::printf("\n");
}

} // namespace

int runAndReport(int argc, char** argv, const std::vector<Claim>& claims)
{
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 1;
    }
    RememberingReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    std::printf("\nInstruction sets of this machine:");
    for (const std::string& name : availableSimdTargets()) {
        std::printf(" %s", name.c_str());
    }
    std::printf("\n");
    for (const Claim& claim : claims) {
        print(reporter, claim);
    }
    return 0;
}

} // namespace fumage::benchmarks
