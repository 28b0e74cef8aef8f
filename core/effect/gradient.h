#pragma once

#include "core/effect/curve.h"

#include <glm/vec3.hpp>

namespace fumage {

struct GradientStop {
    float at = 0.0F;
    glm::vec3 colour{1.0F}; ///< linear RGB, each 0 or more
    friend bool operator==(const GradientStop&, const GradientStop&) = default;
};

/// Colour over life or over heat: stops ascending in [0, 1], joined linearly in linear RGB.
struct Gradient {
    std::array<GradientStop, kMaxControlPoints> storage{};
    int count = 0;

    Gradient() = default;
    /// @param stops 1 to kMaxControlPoints of them, ascending
    Gradient(std::initializer_list<GradientStop> stops);

    /// The stops in use, ascending.
    [[nodiscard]] std::span<const GradientStop> stops() const
    {
        return {storage.data(), static_cast<std::size_t>(count)};
    }

    /// @return the colour at a position; outside of the stops, that of the nearest; white without stops
    [[nodiscard]] glm::vec3 at(float position) const;

    friend bool operator==(const Gradient&, const Gradient&) = default;
};

} // namespace fumage
