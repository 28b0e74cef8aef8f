#include "core/base/vector.h"

#include "core/base/math.h"

#include <cmath>

namespace fumage {

glm::vec3 horizontalDirection(float degrees)
{
    const float angle = radians(degrees);
    return {portableCos(angle), 0.0F, portableSin(angle)};
}

PlaneBasis planeBasis(const glm::vec3& normal)
{
    // A helper that the normal is far from; +x comes first, so that a level emitter is +x by +z.
    constexpr float kNearlyX = 0.9F;
    const glm::vec3 helper = std::abs(normal.x) > kNearlyX ? glm::vec3(0.0F, 0.0F, 1.0F) : glm::vec3(1.0F, 0.0F, 0.0F);
    PlaneBasis basis;
    basis.along = glm::normalize(glm::cross(helper, normal));
    basis.across = glm::cross(normal, basis.along);
    return basis;
}

} // namespace fumage
