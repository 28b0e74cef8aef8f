#pragma once

#include "core/rendering/renderer.h"
#include "core/scene/scene.h"
#include "core/simulation/scene_simulator.h"

#include <memory>
#include <vector>

namespace fumage {

/// The layers of a frame as the renderer takes them: each as it is at that frame.
class LayersAtFrame {
public:
    /// @param frame of the same layers; both outlive this
    LayersAtFrame(const SceneFrame& frame, SampledLayers layers);
    LayersAtFrame(const LayersAtFrame&) = delete; // the frames look at the effects
    LayersAtFrame& operator=(const LayersAtFrame&) = delete;

    [[nodiscard]] operator LayerFrames() const // NOLINT(google-explicit-constructor): it is what they are
    {
        return m_frames;
    }
    [[nodiscard]] const std::vector<LayerFrame>& frames() const { return m_frames; }
    /// What all layers share, as it is at that frame.
    [[nodiscard]] const SampledEffect& surroundings() const { return *m_frames.front().effect; }

private:
    std::vector<SampledEffect> m_changed; ///< where anything changes from frame to frame: all layers
    std::vector<LayerFrame> m_frames;
};

/// Makes pictures of a scene: simulates and renders. Keeps its buffers. Not thread-safe; uses all threads inside.
class SceneRenderer {
public:
    /// @param shelf with air that others bake or have baked; null: none
    explicit SceneRenderer(const Scene& scene, const std::shared_ptr<AirCache>& shelf = nullptr);

    /// @param number of the frame, 0 or more
    /// @param width,height pixels
    /// @param image as of Renderer::render()
    /// @error those of SceneSimulator and Renderer
    [[nodiscard]] Status render(int number, int width, int height, Image& image, const Task& task = {});

    /// The frame alone.
    [[nodiscard]] Result<SceneFrame> frame(int number, const Task& task = {})
    {
        return m_simulator.frame(number, task);
    }
    [[nodiscard]] const std::vector<SampledEffect>& layers() const { return m_layers; }

private:
    std::vector<SampledEffect> m_layers;
    SceneSimulator m_simulator;
    Renderer m_renderer;
};

} // namespace fumage
