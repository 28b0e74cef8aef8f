#include "core/live/birth_budget.h"

#include <algorithm>

namespace fumage {

namespace {

/// Fewer particles than this say nothing about what one costs.
constexpr std::size_t kEnough = 256;

constexpr double kSmoothing = 0.1; ///< weight of the newest step
constexpr double kAim = 0.8; ///< share of the budget that is aimed at: the rest is for steps that take longer than others
constexpr float kRoom = 1.2F; ///< how much more than it uses a share must be allowed before it grows
constexpr float kReturn = 0.05F; ///< of the way back, a step

/// Of what is usual, how much a step may count: one that other programs have interrupted says nothing about what particles cost.
constexpr double kMostCounted = 2.0;

/// @param least that counts whatever is usual
double smoothed(double usual, double now, double least)
{
    return usual + kSmoothing * (std::min(now, std::max(least, kMostCounted * usual)) - usual);
}

} // namespace

float BirthBudget::observe(const StepTimes& times, std::size_t living, std::size_t full)
{
    if (living < kEnough) {
        return m_share;
    }
    const double each = times.particles / static_cast<double>(living);
    const bool isFirst = m_perParticle == 0.0;
    m_perParticle = isFirst ? each : smoothed(m_perParticle, each, 0.0);
    m_air = isFirst ? times.air : smoothed(m_air, times.air, m_seconds);
    const double left = std::max(0.0, kAim * m_seconds - m_air);
    const double allowed = m_perParticle > 0.0 ? left / (m_perParticle * static_cast<double>(full)) : 1.0;
    const auto most = static_cast<float>(std::min(allowed, 2.0));
    if (most < m_share) {
        m_share = std::max(kLeastShare, most);
    } else if (most > kRoom * m_share) {
        m_share += kReturn * (std::min(1.0F, most / kRoom) - m_share);
    }
    return m_share;
}

} // namespace fumage
