#pragma once

#include "core/base/result.h"
#include "core/lighting/fire_workspace.h"
#include "core/lighting/lit_layer.h"
#include "core/lighting/lit_particles.h"

#include <optional>
#include <span>
#include <vector>

namespace fumage {

/// The light on smoke inside a game, found when it is asked for: the same that Renderer::prepare() finds, but for the
/// texture of particles, which nobody here draws. Of several layers there is one density and one light of fire.
///
/// Its memory grows to that of the largest grid so far and is kept.
class LiveLight {
public:
    /// Frames that have changed: what was found is of those before.
    void outdate() { m_isNew = false; }

    /// The colours of findLitColours() of one of the layers, in the light of all. Found on the first call for their
    /// frames, and again for another eye.
    /// @param layers one or more, the same ones, in the same order, until outdate()
    /// @param layer  its place among them
    /// @param eye the camera, m; none: sunlight is scattered evenly, whatever light.anisotropy says
    /// @error OutOfRange where a particle is nowhere, or the eye is
    /// O(particles + cells); allocates nothing but where the grid is larger than any before.
    [[nodiscard]] Result<std::span<const glm::vec4>> colours(
        LayerFrames layers, std::size_t layer, const std::optional<glm::vec3>& eye);
    /// The same of one layer alone.
    [[nodiscard]] Result<std::span<const glm::vec4>> colours(
        const Frame& frame, const SampledEffect& effect, const std::optional<glm::vec3>& eye)
    {
        const LayerFrame alone{&frame, &effect};
        return colours({&alone, 1}, 0, eye);
    }

    /// The normals of findNormals() of one of the layers, out of the smoke of all. Found on the first call for their
    /// frames, with their light where that is not there.
    /// @error OutOfRange where a particle is nowhere
    /// Costs and allocates as colours(), and next to nothing after it.
    [[nodiscard]] Result<std::span<const glm::vec3>> normals(LayerFrames layers, std::size_t layer);
    /// The same of one layer alone.
    [[nodiscard]] Result<std::span<const glm::vec3>> normals(const Frame& frame, const SampledEffect& effect)
    {
        const LayerFrame alone{&frame, &effect};
        return normals({&alone, 1}, 0);
    }

private:
    /// What is found of a layer.
    struct Layer {
        Appearance appearance; ///< with bounds in the axes of the light
        Effect seen; ///< whose smoke looks the same from everywhere where there is no eye
        bool coloursAreNew = false;
        bool normalsAreNew = false;
        std::vector<glm::vec4> colours;
        std::vector<glm::vec3> normals;
    };

    [[nodiscard]] Status find(LayerFrames layers);

    bool m_isNew = false;
    std::optional<glm::vec3> m_eye; ///< that the light was found for last
    std::vector<Layer> m_layers;
    std::vector<LitLayer> m_lit;
    LightGrid m_grid;
    LightWorkspace m_room;
    FireWorkspace m_fireRoom;
    NormalWorkspace m_normalRoom;
};

} // namespace fumage
