#pragma once

#include "core/base/result.h"
#include "core/lighting/fire_workspace.h"
#include "core/lighting/lit_particles.h"

#include <optional>
#include <span>

namespace fumage {

/// The light on smoke inside a game, found when it is asked for: the same that Renderer::prepare() finds, but for the
/// texture of particles, which nobody here draws.
///
/// Its memory grows to that of the largest grid so far and is kept.
class LiveLight {
public:
    /// A frame that has changed: what was found is of the one before.
    void outdate() { m_isNew = m_normalsAreNew = false; }

    /// The colours of findLitColours(). Found on the first call for a frame, and again for another eye.
    /// @param eye the camera, m; none: sunlight is scattered evenly, whatever light.anisotropy says
    /// @error OutOfRange where a particle is nowhere, or the eye is
    /// O(particles + cells); allocates nothing but where the grid is larger than any before.
    [[nodiscard]] Result<std::span<const glm::vec4>> colours(
        const Frame& frame, const SampledEffect& effect, const std::optional<glm::vec3>& eye);

    /// The normals of findNormals(). Found on the first call for a frame, with its light where that is not there.
    /// @error OutOfRange where a particle is nowhere
    /// Costs and allocates as colours(), and next to nothing after it.
    [[nodiscard]] Result<std::span<const glm::vec3>> normals(const Frame& frame, const SampledEffect& effect);

private:
    [[nodiscard]] Status find(const Frame& frame, const SampledEffect& effect);

    bool m_isNew = false;
    bool m_normalsAreNew = false;
    std::optional<glm::vec3> m_eye; ///< that the light was found for last
    Appearance m_appearance; ///< with bounds in the axes of the light
    LightGrid m_grid;
    LightWorkspace m_room;
    FireWorkspace m_fireRoom;
    NormalWorkspace m_normalRoom;
    std::vector<glm::vec4> m_colours;
    std::vector<glm::vec3> m_normals;
};

} // namespace fumage
