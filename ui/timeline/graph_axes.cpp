#include "ui/timeline/graph_axes.h"

#include "ui/document/number_text.h"

#include <algorithm>
#include <cmath>

namespace fumage::ui {

namespace {

constexpr double kTickGap = 28.0; ///< pixels, at least

} // namespace

double roundStep(double atLeast)
{
    // A step that is round already, but for the last bits of its calculation, is taken as it is.
    constexpr double kRounding = 1e-9;
    const double power = std::pow(10.0, std::floor(std::log10(atLeast)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (power * factor >= atLeast * (1.0 - kRounding)) {
            return power * factor;
        }
    }
    return power * 10.0;
}

std::vector<double> roundTicks(double low, double high, double step)
{
    constexpr double kMaxTicks = 1000.0;
    std::vector<double> ticks;
    const double first = std::ceil(low / step);
    const double count = std::floor(high / step) - first;
    for (int i = 0; count < kMaxTicks && i <= count; ++i) {
        ticks.push_back((first + i) * step);
    }
    return ticks;
}

QString tickText(double value, double step, Unit unit)
{
    constexpr int kMaxDigits = 9;
    const double larger = std::max(std::abs(value), step);
    const int digits = static_cast<int>(std::floor(std::log10(larger)) - std::floor(std::log10(step))) + 1;
    return formatNumber(value, unit, std::clamp(digits, 1, kMaxDigits));
}

double ValueAxis::tickStep() const
{
    return roundStep(kTickGap * perPixel());
}

void ValueAxis::frame(double from, double to, double least)
{
    constexpr double kRoom = 0.1; // of what is shown
    const double room = std::max(kRoom * (to - from), least);
    low = from - room;
    high = to + room;
}

void ValueAxis::zoom(double factor, double about)
{
    constexpr double kFinest = 1e-5; // of the values: floats have seven digits
    constexpr double kSmallest = 1e-7;
    constexpr double kLargest = 1e9;
    const double span = high - low;
    const double smallest = std::max(kSmallest, kFinest * std::max(std::abs(low), std::abs(high)));
    const double wanted = std::clamp(span * factor, std::min(span, smallest), std::max(span, kLargest));
    const double share = (about - low) / span;
    low = about - share * wanted;
    high = low + wanted;
}

void ValueAxis::move(double by)
{
    low += by;
    high += by;
}

} // namespace fumage::ui
