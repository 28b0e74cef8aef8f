#pragma once

#include "core/export/sheets/flipbook_options.h"
#include "core/rendering/framing.h"
#include "core/rendering/pass_renderer.h"
#include "core/scene/scene.h"

#include <optional>

namespace fumage {

/// Looks for smoke on the borders of cells with a transparent background.
class BorderWatch {
public:
    /// @param scene must stay
    explicit BorderWatch(const Scene& scene)
        : m_scene(scene)
        , m_framing(scene.camera, scene.output.width, scene.output.height)
    {
    }

    /// Takes a cell in.
    void look(const Image& cell, const FrameAmongOthers& frames, const PassRenderer& renderer);
    /// Writes down what was seen.
    void report(Flipbook& flipbook) const;

private:
    const Scene& m_scene;
    Framing m_framing;
    float m_alpha = 0.0F;
    std::optional<CutOff> m_cutOff;
};

} // namespace fumage
