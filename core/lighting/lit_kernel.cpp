#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lighting/lit_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/lighting/lit_kernel.h"
#include "core/lighting/particle_light-inl.h"
#include "core/simulation/ages-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

void coloursOfBlock(const LitJob& job, std::size_t begin, glm::vec4* out)
{
    const hn::ScalableTag<float> d;
    const Particles& particles = *job.particles;
    LitBlock block;
    for (std::size_t i = 0; i < kLitBlock; i += hn::Lanes(d)) {
        const std::size_t at = begin + i;
        placeInLight(d, job.grid->shape, load(d, particles.x, particles.y, particles.z, at), i, block);
        if (job.colours.glows) {
            const auto key = hn::Load(hn::RebindToUnsigned<decltype(d)>(), particles.key.data() + at);
            const auto age = agesInSteps(d, particles, at, key, job.step, job.bornBetweenSteps) * job.dt;
            findGlow(d, job.colours, particles, at, key, age, i, block);
        }
    }
    for (std::size_t i = 0; i < kLitBlock; ++i) {
        const std::size_t at = begin + i;
        out[i] = glm::vec4(0.0F);
        if (job.appearance->radius[at] > 0.0F) {
            const LitColour lit = litColourOf(job.colours, *job.grid, block, i, job.appearance->life[at]);
            const Float4 sum = lit.direct + lit.ambient;
            out[i] = {sum[0], sum[1], sum[2], job.appearance->alpha[at]};
        }
    }
}

void outwardsOfBlock(const NormalJob& job, std::size_t begin, glm::vec3* out)
{
    const hn::ScalableTag<float> d;
    const Particles& particles = *job.particles;
    LitBlock block;
    for (std::size_t i = 0; i < kLitBlock; i += hn::Lanes(d)) {
        placeInLight(d, *job.shape, load(d, particles.x, particles.y, particles.z, begin + i), i, block);
    }
    const Axes& axes = job.shape->axes;
    for (std::size_t i = 0; i < kLitBlock; ++i) {
        out[i] = glm::vec3(0.0F);
        if (!(job.appearance->radius[begin + i] > 0.0F)) {
            continue;
        }
        const Float4 way = block.at<Float4>(*job.shape, *job.outwards, i);
        const float length = std::sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
        constexpr float kEven = 1e-12F; // 1/m: rounding, no way
        if (length > kEven) {
            out[i] = (axes.u * way[0] + axes.v * way[1] + axes.w * way[2]) / length;
        }
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(coloursOfBlock);
HWY_EXPORT(outwardsOfBlock);

void litColoursOfBlock(const LitJob& job, std::size_t begin, glm::vec4* out)
{
    HWY_DYNAMIC_DISPATCH(coloursOfBlock)(job, begin, out);
}

void normalsOfBlock(const NormalJob& job, std::size_t begin, glm::vec3* out)
{
    HWY_DYNAMIC_DISPATCH(outwardsOfBlock)(job, begin, out);
}

} // namespace fumage
#endif
