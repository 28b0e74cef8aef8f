// The text of a curve or a gradient is either refused, or makes one whose values lie between those of its points,
// wherever it is asked.

#include "tests/fuzz/expect.h"

#include "core/effect/parameter_table.h"
#include "core/effect/value.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

namespace {

using namespace fumage;

constexpr std::array<float, 8> kPlaces{-1.0F, 0.0F, 1e-30F, 0.25F, 0.5F, 0.999999F, 1.0F, 3e38F};
constexpr float kRounding = 1e-5F;

void check(const Curve& curve)
{
    const auto [low, high] = std::minmax_element(curve.points().begin(), curve.points().end(),
        [](const CurvePoint& a, const CurvePoint& b) { return a.y < b.y; });
    const auto holds = [&, least = low->y, most = high->y](float at) {
        const float value = curve.at(at);
        return value >= least - kRounding && value <= most + kRounding;
    };
    FUMAGE_EXPECT(std::all_of(kPlaces.begin(), kPlaces.end(), holds));
    FUMAGE_EXPECT(std::all_of(
        curve.points().begin(), curve.points().end(), [&](const CurvePoint& point) { return holds(point.x); }));
}

void check(const Gradient& gradient)
{
    for (int channel = 0; channel < 3; ++channel) {
        float low = std::numeric_limits<float>::max();
        float high = 0.0F;
        for (const GradientStop& stop : gradient.stops()) {
            low = std::min(low, stop.colour[channel]);
            high = std::max(high, stop.colour[channel]);
        }
        const auto holds = [&](float at) {
            const float value = gradient.at(at)[channel];
            return value >= low - kRounding * high && value <= high * (1.0F + kRounding);
        };
        FUMAGE_EXPECT(std::all_of(kPlaces.begin(), kPlaces.end(), holds));
        FUMAGE_EXPECT(std::all_of(gradient.stops().begin(), gradient.stops().end(),
            [&](const GradientStop& stop) { return holds(stop.at); }));
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    for (const Parameter& parameter : parameterTable()) {
        const Result<Clamped> parsed =
            parameter.kind == Kind::Curve || parameter.kind == Kind::Gradient ? parseValue(parameter, text) : Error{};
        if (!parsed) {
            continue;
        }
        const Value value = clampValue(parameter, parsed.value().value).value;
        if (const auto* curve = std::get_if<Curve>(&value)) {
            check(*curve);
        } else {
            check(std::get<Gradient>(value));
        }
    }
    return 0;
}
