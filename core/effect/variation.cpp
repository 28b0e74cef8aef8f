#include "core/effect/variation.h"

#include "core/base/hash.h"
#include "core/base/math.h"
#include "core/effect/parameter_table.h"
#include "core/effect/value.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fumage {

namespace {

/// Random numbers of one variation: a counter, so that a parameter's number does not depend on which others vary.
class Dice {
public:
    Dice(std::uint32_t seed, std::uint32_t row)
        : m_key(keyOf(seed, row))
    {
    }

    /// @return mean 0, standard deviation 1: four uniform numbers summed (Irwin and Hall)
    float normal()
    {
        float sum = 0.0F;
        for (int i = 0; i < 4; ++i) {
            sum += signedFloat(streamBits(m_key, m_draws++));
        }
        constexpr float kDeviationOfSum = 1.15470054F; // sqrt(4 / 3)
        return sum / kDeviationOfSum;
    }

private:
    std::uint32_t m_key;
    std::uint32_t m_draws = 0;
};

/// What a person would type: three significant digits.
double rounded(double number)
{
    if (number == 0.0) {
        return 0.0;
    }
    const double magnitude = std::pow(10.0, std::floor(std::log10(std::abs(number))) - 2.0);
    return std::round(number / magnitude) * magnitude;
}

/// Moves a number by a share of the soft range. On a log scale the share is of the range's logarithm.
double moved(const Parameter& parameter, double number, double share)
{
    // Nothing means off, but for an angle.
    if (number == 0.0 && parameter.unit != Unit::Degrees) {
        return 0.0;
    }
    const double low = std::max(parameter.soft.low, parameter.hard.low);
    const double high = parameter.soft.high;
    if (parameter.scale == Scale::Log && number > 0.0 && low > 0.0) {
        const float octaves = portableLog(static_cast<float>(high / low)) * static_cast<float>(share);
        return number * static_cast<double>(portableExp(octaves));
    }
    // A value far below its range moves by a share of itself as well: a faint wind stays a wind.
    const double span = std::min(high - low, 4.0 * std::abs(number) + 0.1 * (high - low));
    return number + span * share;
}

Value moved(const Parameter& parameter, const Value& value, float amount, Dice& dice)
{
    const auto share = [&] { return static_cast<double>(amount * dice.normal()); };
    if (const float* number = std::get_if<float>(&value)) {
        return static_cast<float>(rounded(moved(parameter, static_cast<double>(*number), share())));
    }
    if (const int* number = std::get_if<int>(&value)) {
        return static_cast<int>(std::lround(moved(parameter, *number, share())));
    }
    if (const glm::vec3* vector = std::get_if<glm::vec3>(&value)) {
        glm::vec3 out = *vector;
        for (int i = 0; i < 3; ++i) {
            // A colour keeps its character where channels move by a share of themselves; black has room to become dark.
            constexpr float kFromBlack = 0.05F;
            const float reach = parameter.kind == Kind::Colour ? out[i] + kFromBlack : 1.0F;
            out[i] += reach * static_cast<float>(share());
        }
        return out;
    }
    return value;
}

/// Parameters that vary() never touches, whatever it is told: to move them a little has no meaning.
bool canMove(const Parameter& parameter)
{
    switch (parameter.kind) {
    case Kind::Float:
    case Kind::Int:
    case Kind::Direction:
    case Kind::Colour: return true;
    default: return false;
    }
}

} // namespace

bool isCharacter(const Parameter& parameter)
{
    return parameter.varies && canMove(parameter);
}

Effect vary(const Effect& effect, float amount, std::uint32_t seed, const MayVary& mayVary)
{
    Effect out = effect;
    std::uint32_t row = 0;
    for (const Parameter& parameter : parameterTable()) {
        Dice dice(seed, row++);
        if (amount > 0.0F && canMove(parameter) && isVisible(parameter, effect) && mayVary(parameter)) {
            setClamped(out, parameter, moved(parameter, parameter.get(effect), amount, dice));
        }
    }
    return out;
}

} // namespace fumage
