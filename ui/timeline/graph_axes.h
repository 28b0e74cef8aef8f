#pragma once

#include "core/effect/parameter.h"

#include <QString>

#include <vector>

namespace fumage::ui {

/// The least of 1, 2 and 5 times a power of ten that is a step or more.
/// @param atLeast more than 0, finite
[[nodiscard]] double roundStep(double atLeast);

/// All multiples of a step from one value to another, in order.
/// @param step more than 0; one so small that there would be thousands gives none
[[nodiscard]] std::vector<double> roundTicks(double low, double high, double step);

/// A tick as its axis shows it: with so many digits that it differs from the next, and its unit.
[[nodiscard]] QString tickText(double value, double step, Unit unit);

/// Values up a graph.
struct ValueAxis {
    double low = 0.0; ///< at the bottom
    double high = 1.0; ///< at the top; more than low
    double bottom = 1.0; ///< pixels
    double top = 0.0; ///< pixels, less than bottom

    [[nodiscard]] double perPixel() const { return (high - low) / (bottom - top); }
    [[nodiscard]] double yOf(double value) const { return bottom - (value - low) / perPixel(); }
    [[nodiscard]] double valueAt(double y) const { return low + (bottom - y) * perPixel(); }
    /// The distance between its ticks.
    [[nodiscard]] double tickStep() const;

    /// Shows values from one to another, with some room around them.
    /// @param least room to each side
    void frame(double from, double to, double least);
    /// Shows so many times as much, with a value where it was; neither so little that floats run out, nor without end.
    void zoom(double factor, double about);
    void move(double by);
};

/// Times along a graph, in line with the ruler.
struct TimeScale {
    double left = 0.0; ///< of time 0, pixels
    double perSecond = 1.0; ///< pixels
    double right = 0.0; ///< where it ends, pixels

    [[nodiscard]] double xOf(double seconds) const { return left + seconds * perSecond; }
    [[nodiscard]] double secondsAt(double x) const { return (x - left) / perSecond; }
};

} // namespace fumage::ui
