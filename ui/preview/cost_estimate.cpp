#include "ui/preview/cost_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fumage::ui {

namespace {

void blend(double& estimate, double measured)
{
    constexpr double kShareOfNewest = 0.3;
    estimate += (measured - estimate) * kShareOfNewest;
}

} // namespace

void CostEstimate::noteSteps(double particleSteps, qint64 ns)
{
    // Short work measures the clock and the wake-up of threads.
    constexpr double kMin = 20000.0;
    if (particleSteps >= kMin) {
        blend(m_step, static_cast<double>(ns) / particleSteps);
    }
}

void CostEstimate::noteSprites(int particles, qint64 ns)
{
    if (particles > 0) {
        blend(m_sprite, static_cast<double>(ns) / particles);
    }
}

void CostEstimate::notePixels(double pixels, qint64 ns)
{
    if (pixels > 0.0) {
        blend(m_pixel, static_cast<double>(ns) / pixels);
    }
}

int CostEstimate::particlesWithin(qint64 ns, double stepsEach, double drawnShare) const
{
    constexpr double kMinCost = 1e-3; // ns: of particles that neither move nor are drawn there may be any number
    return static_cast<int>(
        std::clamp(static_cast<double>(ns) / std::max(kMinCost, m_step * stepsEach + m_sprite * drawnShare),
            static_cast<double>(kMinParticles), static_cast<double>(kMaxParticles)));
}

int CostEstimate::halvedInto(int count, int affordable)
{
    while (count > affordable && count / 2 >= kMinParticles) {
        count /= 2;
    }
    return count;
}

double CostEstimate::scaleWithin(qint64 ns, int particles, double stepsEach, double pixels, double drawnShare) const
{
    const double left = static_cast<double>(ns) - particles * (m_step * stepsEach + m_sprite * drawnShare);
    // Few steps, so that the picture does not shimmer between sizes.
    constexpr std::array<double, 4> kScales{1.0, 0.75, 0.5, kSmallestScale};
    for (const double scale : kScales) {
        if (m_pixel * pixels * scale * scale <= left) {
            return scale;
        }
    }
    return kScales.back();
}

} // namespace fumage::ui
