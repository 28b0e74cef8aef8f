#include "core/live/birth_budget.h"

#include <algorithm>

namespace fumage {

namespace {

/// Fewer particles than this say nothing about what one costs: what a step costs without any would be theirs.
constexpr std::size_t kEnough = 256;
/// And fewer than this are never too many.
constexpr std::size_t kFew = 32;

constexpr double kSmoothing = 0.1; ///< weight of the newest step
constexpr float kRoom = 1.2F; ///< how much more than it uses a share must be allowed before it grows
constexpr float kReturn = 0.05F; ///< of the way back, a step

/// Of what is usual, how much a step may count: one that other programs have interrupted says nothing about what
/// particles cost.
constexpr double kMaxCounted = 2.0;

constexpr double kTail = 0.01; ///< steps that may take longer
constexpr double kTailPace = 0.1; ///< how far what they take is moved by one of them
constexpr double kMinTail = 1.1; ///< steps are never more even than that for long
constexpr double kInterrupted = 3.0; ///< times what was expected: not for what it does itself

/// @param least that counts whatever is usual
double smoothed(double usual, double now, double least)
{
    return usual + kSmoothing * (std::min(now, std::max(least, kMaxCounted * usual)) - usual);
}

} // namespace

void BirthBudget::learn(const StepTimes& times, double living)
{
    const double each = times.particles / living;
    if (m_perParticle == 0.0) {
        m_perParticle = each;
        m_air = times.air;
        return;
    }
    // A quantile is where as many steps push it up as their share says: each that is longer by 99 times as much as one
    // that is shorter. Where one follows another it is what steps take now, which the means below will know.
    const double ratio = (times.air + times.particles) / (m_air + m_perParticle * living);
    const bool isLong = ratio > m_longest;
    if (ratio < kInterrupted && !(isLong && m_wasLong)) {
        m_longest = std::max(kMinTail, m_longest + kTailPace * (isLong ? 1.0 - kTail : -kTail));
    }
    m_wasLong = isLong;
    m_perParticle = smoothed(m_perParticle, each, 0.0);
    m_air = smoothed(m_air, times.air, m_seconds);
}

float BirthBudget::observe(const StepTimes& times, std::size_t living, std::size_t full)
{
    const bool isKnown = m_perParticle > 0.0;
    if (living < (isKnown ? kFew : kEnough)) {
        m_share += isKnown ? kReturn * (1.0F - m_share)
                           : 0.0F; // or a share that has become small would stay so where few are left to learn from
        return m_share;
    }
    learn(times, static_cast<double>(living));
    const double left = std::max(0.0, m_seconds / m_longest - m_air);
    const double allowed = m_perParticle > 0.0 ? left / (m_perParticle * static_cast<double>(full)) : 1.0;
    const auto most = static_cast<float>(std::min(allowed, 2.0));
    m_isHopeless = most < kMinShare;
    if (most < m_share) {
        m_share = std::max(kMinShare, most);
    } else if (most > kRoom * m_share) {
        m_share += kReturn * (std::min(1.0F, most / kRoom) - m_share);
    }
    return m_share;
}

} // namespace fumage
