#include "core/simulation/air_source.h"

#include "core/base/math.h"
#include "core/base/vector.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace fumage {

float sourceRadius(const Emitter& emitter)
{
    return isRectangular(emitter) ? std::sqrt(emitter.width * emitter.depth / kPi) : emitter.radius;
}

glm::vec2 sourceReach(const Emitter& emitter)
{
    return isRectangular(emitter) ? glm::vec2(0.5F * emitter.width, 0.5F * emitter.depth) : glm::vec2(emitter.radius);
}

float alongNormal(const Emitter& emitter)
{
    const float cosine = portableCos(0.5F * radians(emitter.spread));
    return cosine * cosine;
}

glm::vec3 sourceDepth(const Emitter& emitter, const AirGrid& grid)
{
    if (emitter.shape == EmitterShape::Sphere) {
        return glm::vec3(0.0F);
    }
    constexpr float kShareOfRadius = 0.4F;
    constexpr float kMinCells = 1.5F;
    return glm::normalize(emitter.normal) * std::max(kShareOfRadius * sourceRadius(emitter), kMinCells * grid.cell);
}

std::array<glm::vec3, 2> sourceSides(const Emitter& emitter)
{
    const PlaneBasis basis = planeBasis(glm::normalize(emitter.normal));
    constexpr float kMin = 1e-6F; // m: a point has no sides
    const glm::vec2 reach = glm::max(sourceReach(emitter), glm::vec2(kMin));
    return {basis.across / reach.x, basis.along / reach.y};
}

glm::vec3 sourceVelocity(const Emitter& emitter)
{
    return glm::normalize(emitter.normal) * (emitter.speed * alongNormal(emitter));
}

} // namespace fumage
