#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fumage {

/// How far numbers are from others: peak signal to noise ratio against a peak of 1.
class Difference {
public:
    void add(float a, float b)
    {
        const double difference = static_cast<double>(a) - static_cast<double>(b);
        m_sum += difference * difference;
        ++m_count;
    }
    void add(const Difference& other)
    {
        m_sum += other.m_sum;
        m_count += other.m_count;
    }
    [[nodiscard]] double decibels() const
    {
        constexpr double kMax = 99.0; // of what is the same
        return m_sum > 0.0 ? std::min(kMax, 10.0 * std::log10(static_cast<double>(m_count) / m_sum)) : kMax;
    }

private:
    double m_sum = 0.0;
    std::size_t m_count = 0;
};

} // namespace fumage
