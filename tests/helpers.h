#pragma once

#include "tests/effects.h"

#include "core/base/simd.h"
#include "core/rendering/renderer.h"
#include "core/simulation/simulator.h"

#include <cmath>
#include <cstring>

#include <QtTest/QtTest>

namespace fumage::tests {

inline std::shared_ptr<const Frame> frameOf(const Effect& effect, int number)
{
    Simulator simulator(sampled(effect));
    return simulator.frame(number).value();
}

inline int livingCount(const Frame& frame)
{
    int alive = 0;
    for (std::size_t i = 0; i < frame.particles.capacity; ++i) {
        alive += lifecycle(frame, i).alive ? 1 : 0;
    }
    return alive;
}

/// A frame as a scene of one layer has it.
struct LayerOf {
    SampledEffect effect;
    LayerFrame layer;

    LayerOf(const Frame& frame, const Effect& of)
        : effect(sampled(of))
        , layer{&frame, &effect}
    {
    }
    [[nodiscard]] LayerFrames span() const { return {&layer, 1}; }
};

inline Image render(const Effect& effect, int number)
{
    Renderer renderer;
    Image image;
    const Status status =
        renderer.render(*frameOf(effect, number), sampled(effect), effect.output.width, effect.output.height, image);
    if (!status) {
        qFatal("%s", status.error().text().c_str());
    }
    return image;
}

template <class T, class Memory>
bool sameBits(const std::vector<T, Memory>& a, const std::vector<T, Memory>& b)
{
    return a.size() == b.size()
        && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0); // memcmp must not be given null
}

inline bool sameBits(const Particles& a, const Particles& b)
{
    bool same = a.capacity == b.capacity;
    forEachColumn([&](const auto& column) { same = same && sameBits(column.of(a), column.of(b)); });
    return same;
}

/// Says what is wrong where a value is not what is expected.
inline bool near(double value, double expected, double tolerance)
{
    if (std::abs(value - expected) <= tolerance) {
        return true;
    }
    qWarning("%.9g is not %.9g within %.3g", value, expected, tolerance);
    return false;
}

/// Puts the best instruction set back at the end of a test that forced another.
class SimdGuard {
public:
    SimdGuard() = default;
    ~SimdGuard() { (void)forceSimdTarget(""); }
    SimdGuard(const SimdGuard&) = delete;
    SimdGuard& operator=(const SimdGuard&) = delete;
};

/// Mean and variance of numbers, in double.
struct Moments {
    double mean = 0.0;
    double variance = 0.0;
    double low = 1e30;
    double high = -1e30;

    template <class Range>
    static Moments of(const Range& values)
    {
        Moments m;
        double n = 0.0;
        double m2 = 0.0;
        for (const auto value : values) {
            const auto x = static_cast<double>(value);
            n += 1.0;
            const double delta = x - m.mean;
            m.mean += delta / n;
            m2 += delta * (x - m.mean);
            m.low = std::min(m.low, x);
            m.high = std::max(m.high, x);
        }
        m.variance = m2 / n;
        return m;
    }
};

/// Correlation of two columns of numbers.
template <class Range>
double correlation(const Range& a, const Range& b)
{
    const Moments ma = Moments::of(a);
    const Moments mb = Moments::of(b);
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += (static_cast<double>(a[i]) - ma.mean) * (static_cast<double>(b[i]) - mb.mean);
    }
    return sum / static_cast<double>(a.size()) / std::sqrt(ma.variance * mb.variance);
}

} // namespace fumage::tests
