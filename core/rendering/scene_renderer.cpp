#include "core/rendering/scene_renderer.h"

namespace fumage {

std::vector<LayerFrame> layerFrames(const SceneFrame& frame, SampledLayers layers)
{
    std::vector<LayerFrame> out;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        out.push_back({frame.layers[i].get(), &layers[i]});
    }
    return out;
}

SceneRenderer::SceneRenderer(const Scene& scene, const std::shared_ptr<AirCache>& shelf)
    : m_layers(sampledLayers(scene))
    , m_simulator(m_layers, Simulator::kDefaultCheckpointBytes, shelf)
{
}

Status SceneRenderer::render(int number, int width, int height, Image& image, const Task& task)
{
    const Result<SceneFrame> frame = m_simulator.frame(number, task);
    return frame ? m_renderer.render(layerFrames(frame.value(), m_layers), width, height, image, task.stop)
                 : Status(frame.error());
}

} // namespace fumage
