#include "core/effect/curve.h"

#include <algorithm>
#include <cassert>

namespace fumage {

namespace {

float secant(const CurvePoint& a, const CurvePoint& b)
{
    return b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0.0F;
}

/// Slope at a point: the harmonic mean of its secants, 0 at an extremum and flat at the ends.
float slope(std::span<const CurvePoint> points, std::size_t i)
{
    if (i == 0) {
        return secant(points[0], points[1]);
    }
    if (i + 1 == points.size()) {
        return secant(points[i - 1], points[i]);
    }
    const float before = secant(points[i - 1], points[i]);
    const float after = secant(points[i], points[i + 1]);
    return before * after <= 0.0F ? 0.0F : 2.0F * before * after / (before + after);
}

} // namespace

Curve::Curve(std::initializer_list<CurvePoint> points)
    : count(static_cast<int>(points.size()))
{
    assert(points.size() >= 1 && points.size() <= storage.size());
    std::copy(points.begin(), points.end(), storage.begin());
}

float Curve::at(float x) const
{
    const std::span<const CurvePoint> all = points();
    if (all.empty()) {
        return 1.0F;
    }
    if (x <= all.front().x) {
        return all.front().y;
    }
    if (x >= all.back().x) {
        return all.back().y;
    }
    std::size_t i = 0;
    while (all[i + 1].x < x) {
        ++i;
    }
    const float width = all[i + 1].x - all[i].x;
    const float t = (x - all[i].x) / width;
    const float t2 = t * t;
    const float t3 = t2 * t;
    return (2.0F * t3 - 3.0F * t2 + 1.0F) * all[i].y + (t3 - 2.0F * t2 + t) * width * slope(all, i)
        + (3.0F * t2 - 2.0F * t3) * all[i + 1].y + (t3 - t2) * width * slope(all, i + 1);
}

} // namespace fumage
