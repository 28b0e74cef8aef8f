#include "ui/timeline/graph_curves.h"

#include "ui/document/parameter_text.h"

#include "core/effect/value.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace fumage::ui {

namespace {

struct GraphCurves {
    Q_DECLARE_TR_FUNCTIONS(GraphCurves)
};

const std::array kComponentColours{QColor(226, 92, 82), QColor(96, 178, 92), QColor(88, 140, 236)};
/// Of several numbers beside each other, after the first.
const std::array kMoreColours{QColor(224, 160, 64), QColor(170, 120, 220), QColor(70, 180, 180), QColor(210, 110, 160)};

QString componentName(Kind kind, std::size_t component)
{
    static constexpr std::array kAxes{u"x", u"y", u"z"};
    if (kind == Kind::Colour) {
        return std::array{GraphCurves::tr("red"), GraphCurves::tr("green"), GraphCurves::tr("blue")}[component];
    }
    return QString::fromUtf16(kAxes[component]);
}

/// Times at which a curve is looked at, s, in order.
std::vector<double> sampledTimes(const Track& track, const TimeScale& scale)
{
    constexpr double kStep = 2.0; // pixels
    std::vector<double> times;
    for (double x = scale.left; x < scale.right; x += kStep) {
        times.push_back(scale.secondsAt(x));
    }
    times.push_back(scale.secondsAt(scale.right));
    for (const KeyFrame& key : track.keys) {
        if (scale.xOf(key.seconds) < scale.right) {
            times.push_back(key.seconds);
        }
    }
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

/// The key that holds its value until a time; null: the value does not come to that time so.
const KeyFrame* heldUntil(const Track& track, double seconds)
{
    const auto at = std::lower_bound(track.keys.begin(), track.keys.end(), seconds,
        [](const KeyFrame& key, double sought) { return key.seconds < sought; });
    if (at == track.keys.begin() || at == track.keys.end() || at->seconds != seconds) {
        return nullptr;
    }
    const KeyFrame& before = *(at - 1);
    return before.ease == Ease::Hold || !interpolates(track.parameter->kind) ? &before : nullptr;
}

void addCurves(std::vector<GraphCurve>& curves, const Track& track, const TimeScale& scale)
{
    const std::size_t begin = curves.size();
    const std::size_t count = componentCount(track.parameter->kind);
    for (std::size_t component = 0; component < count; ++component) {
        GraphCurve curve{track.parameter, component, fullLabelOf(*track.parameter), {},
            scale.xOf(track.keys.front().seconds), scale.xOf(track.keys.back().seconds), {}};
        if (count > 1) {
            curve.name += QLatin1Char(' ') + componentName(track.parameter->kind, component);
            curve.colour = kComponentColours[component];
        } else if (begin > 0) {
            curve.colour = kMoreColours[(begin - 1) % kMoreColours.size()];
        }
        curves.push_back(std::move(curve));
    }
    for (const double seconds : sampledTimes(track, scale)) {
        const double x = scale.xOf(seconds);
        const Value value = track.at(seconds);
        const KeyFrame* held = heldUntil(track, seconds);
        for (std::size_t component = 0; component < count; ++component) {
            std::vector<GraphPoint>& points = curves[begin + component].points;
            if (held != nullptr) {
                points.push_back({x, componentOf(held->value, component)});
            }
            points.push_back({x, componentOf(value, component)});
        }
    }
}

} // namespace

std::size_t componentCount(Kind kind)
{
    return kind == Kind::Vector || kind == Kind::Direction || kind == Kind::Colour ? 3 : 1;
}

double componentOf(const Value& value, std::size_t component)
{
    if (const auto* number = std::get_if<float>(&value)) {
        return static_cast<double>(*number);
    }
    if (const auto* vector = std::get_if<glm::vec3>(&value)) {
        return static_cast<double>((*vector)[static_cast<glm::length_t>(component)]);
    }
    if (const auto* whole = std::get_if<int>(&value)) {
        return *whole;
    }
    const auto* on = std::get_if<bool>(&value);
    return on != nullptr && *on ? 1.0 : 0.0;
}

bool isRaised(Kind kind)
{
    return interpolates(kind) || kind == Kind::Int;
}

Value withComponent(const Parameter& parameter, const Value& value, std::size_t component, double number)
{
    const double inside = std::clamp(number, parameter.hard.low, parameter.hard.high);
    if (parameter.kind == Kind::Int) {
        return static_cast<int>(std::lround(inside));
    }
    if (const auto* vector = std::get_if<glm::vec3>(&value)) {
        glm::vec3 changed = *vector;
        changed[static_cast<glm::length_t>(component)] = static_cast<float>(inside);
        return clampValue(parameter, changed).value;
    }
    return clampValue(parameter, static_cast<float>(inside)).value;
}

double GraphCurve::valueAt(double x) const
{
    const auto next = std::lower_bound(
        points.begin(), points.end(), x, [](const GraphPoint& point, double sought) { return point.x < sought; });
    if (next == points.end()) {
        return points.empty() ? 0.0 : points.back().value;
    }
    if (next == points.begin() || next->x == x) {
        return next->value;
    }
    const GraphPoint& before = *(next - 1);
    return before.value + (next->value - before.value) * (x - before.x) / (next->x - before.x);
}

std::vector<GraphCurve> sampleCurves(const std::vector<const Track*>& tracks, const TimeScale& scale)
{
    std::vector<GraphCurve> curves;
    for (const Track* track : tracks) {
        addCurves(curves, *track, scale);
    }
    return curves;
}

std::pair<double, double> rangeOf(const std::vector<GraphCurve>& curves)
{
    std::pair<double, double> range{0.0, 1.0};
    bool isFirst = true;
    for (const GraphCurve& curve : curves) {
        for (const GraphPoint& point : curve.points) {
            range = isFirst ? std::pair(point.value, point.value)
                            : std::pair(std::min(range.first, point.value), std::max(range.second, point.value));
            isFirst = false;
        }
    }
    return range;
}

} // namespace fumage::ui
