#pragma once

#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace fumage::benchmarks {

/// A line of the closing table: a figure from one or two benchmarks beside what it should reach.
struct Claim {
    std::string what;
    std::string benchmark; ///< full name as Google Benchmark prints it
    std::string
        baseline; ///< name of another: the figure is baseline time / benchmark time; empty: the counter or time itself
    std::string counter; ///< user counter to show; empty: milliseconds
    double target = 0.0; ///< 0: shown only
    bool atMost = false; ///< the figure should not exceed the target; else reach it
};

/// Runs what --benchmark_filter selects and prints the claims whose benchmarks ran.
int runAndReport(int argc, char** argv, const std::vector<Claim>& claims);

// Each file registers its benchmarks and adds its claims.
void addAirBenchmarks(std::vector<Claim>& claims);
void addStepBenchmarks(std::vector<Claim>& claims);
void addNoiseBenchmarks(std::vector<Claim>& claims);
void addCompositorBenchmarks(std::vector<Claim>& claims);
void addFrameBenchmarks(std::vector<Claim>& claims);
void addLiveBenchmarks(std::vector<Claim>& claims);

} // namespace fumage::benchmarks
