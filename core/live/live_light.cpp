#include "core/live/live_light.h"

#include "core/lighting/fire_light.h"
#include "core/lighting/light_grid.h"
#include "core/lighting/soft_light.h"

#include <cmath>

namespace fumage {

namespace {

/// An effect whose smoke looks the same from everywhere.
Effect even(const Effect& effect)
{
    Effect out = effect;
    out.light.anisotropy = 0.0F;
    return out;
}

} // namespace

Status LiveLight::find(const Frame& frame, const SampledEffect& effect)
{
    m_isNew = false;
    m_normalsAreNew = false;
    findAppearance(frame, effect, lightAxes(effect->light.direction), m_appearance);
    if (Status status = checkBounds(m_appearance); !status) {
        return status;
    }
    const Effect seen = m_eye ? effect : even(effect);
    const LitLayer layer{&frame, &seen, &m_appearance, nullptr};
    lightSmoke({&layer, 1}, m_eye.value_or(glm::vec3(0.0F)), m_room, m_grid);
    softenLight(m_grid, m_room);
    lightByFire({&layer, 1}, m_fireRoom, m_room, m_grid);
    findLitColours(frame, effect, m_appearance, m_grid, m_colours);
    m_isNew = true;
    return Done{};
}

Result<std::span<const glm::vec4>> LiveLight::colours(
    const Frame& frame, const SampledEffect& effect, const std::optional<glm::vec3>& eye)
{
    if (eye && !std::isfinite(eye->x + eye->y + eye->z)) {
        return Error{ErrorCode::OutOfRange, makeMessage("the eye's place is no number"), {},
            makeMessage("Pass finite numbers, or no eye")};
    }
    if (!m_isNew || m_eye != eye) {
        m_eye = eye;
        if (Status status = find(frame, effect); !status) {
            return status.error();
        }
    }
    return std::span<const glm::vec4>(m_colours).first(frame.particles.capacity);
}

Result<std::span<const glm::vec3>> LiveLight::normals(const Frame& frame, const SampledEffect& effect)
{
    if (!m_isNew) {
        if (Status status = find(frame, effect); !status) {
            return status.error();
        }
    }
    if (!m_normalsAreNew) {
        findNormals(frame, m_appearance, m_grid, m_normalRoom, m_normals);
        m_normalsAreNew = true;
    }
    return std::span<const glm::vec3>(m_normals).first(frame.particles.capacity);
}

} // namespace fumage
