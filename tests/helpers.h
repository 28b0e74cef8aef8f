#pragma once

#include "core/base/simd.h"
#include "core/rendering/renderer.h"
#include "core/simulation/simulator.h"

#include <cstring>

#include <QtTest/QtTest>

namespace fumage::tests {

/// An effect with few particles and everything of part 2 switched on, so that every parameter has something to change.
inline Effect everythingOn()
{
    Effect e;
    e.emitter.count = 1500;
    e.emitter.velocityRandomness = 0.3F;
    e.motion.wind = 0.6F;
    e.motion.gravity = 0.2F;
    e.motion.randomness = 0.4F;
    e.motion.rotation = 20.0F;
    e.motion.rotationJitter = 10.0F;
    e.turbulence.octaves = 2;
    e.vortex.strength = 0.4F;
    e.look.size = 0.6F;
    e.look.texture = 0.9F;
    e.look.erosion = 0.6F;
    e.look.relief = 0.5F;
    e.look.roundness = 0.3F;
    e.look.spin = 10.0F;
    e.look.roll = 0.5F;
    e.look.stretch = 0.05F;
    e.light.emission = 2.0F;
    e.light.hotCore = 0.3F;
    e.noise.basis = NoiseBasis::Gradient;
    e.noise.resolution = 32;
    e.noise.slices = 8;
    e.noise.octaves = 3;
    e.light.resolution = 24;
    e.camera.turntable = 10.0F;
    e.output.width = 96;
    e.output.height = 96;
    e.output.background = Background::Colour;
    return e;
}

/// The motion of the 2012 model alone: no part 2, nothing random but what a test switches on.
inline Effect thesisEffect(int count)
{
    Effect e;
    e.emitter = {};
    e.emitter.shape = EmitterShape::Rectangle;
    e.emitter.width = 1.0F;
    e.emitter.depth = 1.0F;
    e.emitter.count = count;
    e.emitter.speed = 1.0F;
    e.emitter.velocityRandomness = 0.0F;
    e.emitter.spread = 0.0F;
    e.emitter.subframe = false;
    e.motion = {};
    e.motion.wind = 0.0F;
    e.motion.gust = 0.0F;
    e.motion.drag = 0.0F;
    e.motion.buoyancy = 0.0F;
    e.motion.heatVariance = 0.0F;
    e.motion.pull = 0.0F;
    e.turbulence.strength = 0.0F;
    e.rings.strength = 0.0F;
    e.life.initialAlpha = 0.1F;
    e.life.fadeRate = 0.02F;
    e.life.lifetimeVariance = 0.0F;
    e.timeline.frameRate = 30;
    e.timeline.prewarm = false;
    return e;
}

inline std::shared_ptr<const Frame> frameOf(const Effect& effect, int number)
{
    Simulator simulator(effect);
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

inline Image render(const Effect& effect, int number)
{
    Renderer renderer;
    Image image;
    const Status status = renderer.render(*frameOf(effect, number), effect, effect.output.width, effect.output.height, image);
    if (!status) {
        qFatal("%s", status.error().text().c_str());
    }
    return image;
}

template <class T>
bool sameBits(const AlignedArray<T>& a, const AlignedArray<T>& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

inline bool sameBits(const Particles& a, const Particles& b)
{
    return sameBits(a.x, b.x) && sameBits(a.y, b.y) && sameBits(a.z, b.z) && sameBits(a.vx, b.vx) && sameBits(a.vy, b.vy) && sameBits(a.vz, b.vz) && sameBits(a.key, b.key)
        && sameBits(a.birthStep, b.birthStep);
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
