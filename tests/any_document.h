#pragma once

#include "core/base/hash.h"
#include "core/effect/parameter_table.h"
#include "core/effect/value.h"
#include "core/effect/variation.h"
#include "core/preset/library.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <QtTest/QtTest>

// Documents that nobody would write: random numbers within their ranges, and variations of variations.

namespace fumage::tests {

/// FUMAGE_SMOKES=10000 tries as many of each kind.
/// @param few without it: as many as take seconds
inline int smokesOfAKind(int few)
{
    bool isSet = false;
    const int asked = qEnvironmentVariableIntValue("FUMAGE_SMOKES", &isSet);
    return isSet ? asked : few;
}

inline float unit(std::uint32_t seed, std::uint32_t draw)
{
    return unitFloat(streamBits(keyOf(seed, 77), draw));
}

/// Anywhere in a range: at an end of it, evenly, or by its magnitude.
inline double anywhere(const Range& range, float how, float where)
{
    const double low = range.low;
    const double high = range.high;
    if (how < 0.1F) {
        return where < 0.5F ? low : high;
    }
    if (how < 0.4F) {
        return low + (high - low) * static_cast<double>(where);
    }
    const double magnitude = std::pow(10.0, -4.0 + 4.0 * static_cast<double>(std::abs(2.0F * where - 1.0F)));
    return std::clamp(where < 0.5F && low < 0.0 ? low * magnitude : high * magnitude, low, high);
}

inline Value anyValue(const Parameter& parameter, const Value& now, std::uint32_t seed, std::uint32_t row)
{
    std::uint32_t draw = 16 * row;
    const auto next = [&] { return unit(seed, draw++); };
    const auto number = [&] {
        const float how = next();
        return anywhere(parameter.hard, how, next());
    };
    if (std::holds_alternative<bool>(now)) {
        return next() < 0.5F;
    }
    if (std::holds_alternative<int>(now)) {
        const double choices = static_cast<double>(parameter.choices.size());
        return static_cast<int>(
            parameter.kind == Kind::Choice ? std::floor(choices * static_cast<double>(next())) : std::round(number()));
    }
    if (std::holds_alternative<float>(now)) {
        return static_cast<float>(number());
    }
    if (std::holds_alternative<glm::vec3>(now)) {
        const auto x = static_cast<float>(number());
        const auto y = static_cast<float>(number());
        return glm::vec3(x, y, static_cast<float>(number()));
    }
    return std::holds_alternative<std::uint32_t>(now) ? Value(streamBits(seed, row)) : now;
}

/// A document in which each parameter is anything with a probability that differs from document to document.
inline Effect anyDocument(std::uint32_t seed)
{
    Effect effect;
    const float share = 0.05F + 0.6F * unit(seed, 0);
    std::uint32_t row = 1;
    for (const Parameter& parameter : parameterTable()) {
        if (unit(seed, 16 * row + 15) < share) {
            setClamped(effect, parameter, anyValue(parameter, parameter.get(effect), seed, row));
        }
        ++row;
    }
    effect.air.enabled = unit(seed, 1) < 0.8F;
    effect.air.fit = unit(seed, 2) < 0.7F;
    return effect;
}

/// What costs time, and nothing else, as small as it may be.
inline Effect made(Effect effect)
{
    constexpr int kCells = 16; // of the air
    constexpr int kParticles = 400;
    constexpr float kMaxSteps = 40.0F; // of a life
    effect.emitter.count = std::min(effect.emitter.count, kParticles);
    effect.air.resolution = std::min(effect.air.resolution, kCells);
    effect.noise.resolution = 8;
    effect.noise.slices = 1;
    effect.noise.octaves = 1;
    effect.light.resolution = std::min(effect.light.resolution, 16);
    effect.output.supersample = 1;
    effect.timeline.stepsPerFrame = std::min(effect.timeline.stepsPerFrame, 2);
    effect.timeline.length = std::min(effect.timeline.length, 20);
    const float steps = static_cast<float>(effect.timeline.frameRate * effect.timeline.stepsPerFrame);
    effect.life.fadeRate = std::max(effect.life.fadeRate, effect.life.initialAlpha * steps / kMaxSteps);
    return effect;
}

/// The smoke of a point in air that nothing moves.
inline Effect pointInStillAir()
{
    Effect effect;
    effect.emitter = {};
    effect.emitter.radius = 0.0F;
    effect.emitter.speed = 0.0F;
    effect.wind.strength = 0.0F;
    effect.turbulence.strength = 0.0F;
    effect.air.enabled = true;
    return effect;
}

/// Smokes of which each is a wild variation of the one before it; a line begins at each built-in preset and at a point
/// source.
class Breeder {
public:
    Breeder()
    {
        for (const LibraryEntry& entry : builtinPresets()) {
            m_parents.push_back(loadPreset(entry).value().preset.scene.effect());
        }
        m_parents.push_back(pointInStillAir());
    }

    /// @param number counted from 0
    [[nodiscard]] const Effect& bred(int number)
    {
        Effect& parent = m_parents[static_cast<std::size_t>(number) % m_parents.size()];
        constexpr float kWild = 0.4F;
        parent = vary(parent, kWild, static_cast<std::uint32_t>(number));
        return parent;
    }

private:
    std::vector<Effect> m_parents;
};

} // namespace fumage::tests
