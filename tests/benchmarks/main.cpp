#include "tests/benchmarks/measure.h"

int main(int argc, char** argv)
{
    using namespace fumage::benchmarks;
    std::vector<Claim> claims;
    addStepBenchmarks(claims);
    addAirBenchmarks(claims);
    addNoiseBenchmarks(claims);
    addCompositorBenchmarks(claims);
    addFrameBenchmarks(claims);
    addLiveBenchmarks(claims);
    return runAndReport(argc, argv, claims);
}
