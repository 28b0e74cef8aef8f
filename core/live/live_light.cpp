#include "core/live/live_light.h"

#include "core/lighting/appearance.h"
#include "core/lighting/fire_light.h"
#include "core/lighting/light_grid.h"
#include "core/lighting/soft_light.h"

#include <cmath>

namespace fumage {

Status LiveLight::find(LayerFrames layers)
{
    m_isNew = false;
    m_layers.resize(layers.size());
    m_lit.clear();
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const SampledEffect& effect = *layers[i].effect;
        Layer& own = m_layers[i];
        own.coloursAreNew = own.normalsAreNew = false;
        findAppearance(*layers[i].frame, effect, lightAxes(effect->light.direction), own.appearance);
        if (Status status = checkBounds(own.appearance); !status) {
            return status;
        }
        own.seen = effect;
        own.seen.light.anisotropy = m_eye ? effect->light.anisotropy : 0.0F;
        m_lit.push_back({layers[i].frame, &own.seen, &own.appearance, nullptr});
    }
    lightSmoke(m_lit, m_eye.value_or(glm::vec3(0.0F)), m_room, m_grid);
    softenLight(m_grid, m_room);
    lightByFire(m_lit, m_fireRoom, m_room, m_grid);
    m_isNew = true;
    return Done{};
}

Result<std::span<const glm::vec4>> LiveLight::colours(
    LayerFrames layers, std::size_t layer, const std::optional<glm::vec3>& eye)
{
    if (eye && !std::isfinite(eye->x + eye->y + eye->z)) {
        return Error{ErrorCode::OutOfRange, makeMessage("the eye's place is no number"), {},
            makeMessage("Pass finite numbers, or no eye")};
    }
    if (!m_isNew || m_eye != eye) {
        m_eye = eye;
        if (Status status = find(layers); !status) {
            return status.error();
        }
    }
    const Frame& frame = *layers[layer].frame;
    Layer& own = m_layers[layer];
    if (!own.coloursAreNew) {
        findLitColours(frame, *layers[layer].effect, own.appearance, m_grid, own.colours);
        own.coloursAreNew = true;
    }
    return std::span<const glm::vec4>(own.colours).first(frame.particles.capacity);
}

Result<std::span<const glm::vec3>> LiveLight::normals(LayerFrames layers, std::size_t layer)
{
    if (!m_isNew) {
        if (Status status = find(layers); !status) {
            return status.error();
        }
    }
    const Frame& frame = *layers[layer].frame;
    Layer& own = m_layers[layer];
    if (!own.normalsAreNew) {
        findNormals(frame, own.appearance, m_grid, m_normalRoom, own.normals);
        own.normalsAreNew = true;
    }
    return std::span<const glm::vec3>(own.normals).first(frame.particles.capacity);
}

} // namespace fumage
