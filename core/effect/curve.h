#pragma once

#include <array>
#include <span>

namespace fumage {

/// Most control points a Curve or stops a Gradient holds; fixed, so that an Effect is plain data.
inline constexpr int kMaxControlPoints = 16;

struct CurvePoint {
    float x = 0.0F;
    float y = 0.0F;
    friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

/// A function over life: control points with x ascending in [0, 1], y in [0, 1], joined by a monotone cubic so that the
/// curve never leaves the range of its neighbours.
struct Curve {
    std::array<CurvePoint, kMaxControlPoints> storage{};
    int count = 0;

    Curve() = default;
    /// @param points 1 to kMaxControlPoints of them, x ascending
    Curve(std::initializer_list<CurvePoint> points);

    /// The control points in use, x ascending.
    [[nodiscard]] std::span<const CurvePoint> points() const
    {
        return {storage.data(), static_cast<std::size_t>(count)};
    }

    /// @return the value at x; outside of the points, that of the nearest
    /// Source: Fritsch and Carlson, "Monotone Piecewise Cubic Interpolation", SIAM J. Numer. Anal. 17, 1980.
    [[nodiscard]] float at(float x) const;

    friend bool operator==(const Curve&, const Curve&) = default;
};

} // namespace fumage
