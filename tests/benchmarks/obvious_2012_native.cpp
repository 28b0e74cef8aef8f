#include "tests/benchmarks/obvious.h"

#define FUMAGE_OBVIOUS obviousNative
#include "tests/benchmarks/obvious_2012.inc"

namespace fumage::benchmarks {

namespace {

struct RunnerNative : Obvious2012 {
    FUMAGE_OBVIOUS::Program program;
    explicit RunnerNative(int particles)
        : program(particles)
    {
    }
    void step() override { program.step(1.0F / 30.0F, 0.4F, 0.3F, 0.5F, 0.02F); }
};

} // namespace

std::unique_ptr<Obvious2012> makeObvious2012Native(int particles)
{
    return std::make_unique<RunnerNative>(particles);
}

} // namespace fumage::benchmarks
