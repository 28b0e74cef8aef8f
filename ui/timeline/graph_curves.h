#pragma once

#include "ui/timeline/graph_axes.h"

#include "core/effect/track.h"

#include <QColor>
#include <QString>

#include <utility>
#include <vector>

namespace fumage::ui {

/// How many curves a parameter has: three for vectors, directions and colours, else one.
[[nodiscard]] std::size_t componentCount(Kind kind);

/// One number of a value: of a choice its place in the list, of a switch 0 or 1, of what has no number 0.
/// @param component less than componentCount()
[[nodiscard]] double componentOf(const Value& value, std::size_t component);

/// Whether the hand moves the values of a kind up and down; choices and switches are steps.
[[nodiscard]] bool isRaised(Kind kind);

/// A value with another number in it, in the hard range of its parameter.
/// @param value of a kind that isRaised()
[[nodiscard]] Value withComponent(const Parameter& parameter, const Value& value, std::size_t component, double number);

/// A place of a curve.
struct GraphPoint {
    double x = 0.0; ///< pixels
    double value = 0.0;
};

/// One curve of a track as it is drawn.
struct GraphCurve {
    const Parameter* parameter = nullptr;
    std::size_t component = 0;
    QString name; ///< "Emitter: Position x"
    QColor colour; ///< that of the theme where it is not valid
    double first = 0.0; ///< x of the first key, pixels
    double last = 0.0; ///< x of the last one
    std::vector<GraphPoint> points; ///< from left to right; two at one x where the value jumps

    /// @return the value at a place, between its points
    [[nodiscard]] double valueAt(double x) const;
};

/// The curves of tracks, with a point every two pixels and at each key frame.
/// O(pixels * tracks * log(keys)).
[[nodiscard]] std::vector<GraphCurve> sampleCurves(const std::vector<const Track*>& tracks, const TimeScale& scale);

/// The least and the largest value of curves; 0 and 1 where there are none.
[[nodiscard]] std::pair<double, double> rangeOf(const std::vector<GraphCurve>& curves);

} // namespace fumage::ui
