#include "core/rendering/scene_renderer.h"

#include <algorithm>

namespace fumage {

LayersAtFrame::LayersAtFrame(const SceneFrame& frame, SampledLayers layers)
{
    const bool changes =
        std::any_of(layers.begin(), layers.end(), [](const SampledEffect& layer) { return layer.tracks() != nullptr; });
    m_changed.reserve(changes ? layers.size() : 0);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (changes) {
            m_changed.push_back(layers[i].atFrame(frame.layers[i]->number));
        }
        m_frames.push_back({frame.layers[i].get(), changes ? &m_changed[i] : &layers[i]});
    }
}

SceneRenderer::SceneRenderer(const Scene& scene, const std::shared_ptr<AirCache>& shelf)
    : m_layers(sampledLayers(scene))
    , m_simulator(m_layers, Simulator::kDefaultCheckpointBytes, shelf)
{
}

Status SceneRenderer::render(int number, int width, int height, Image& image, const Task& task)
{
    const Result<SceneFrame> frame = m_simulator.frame(number, task);
    return frame ? m_renderer.render(LayersAtFrame(frame.value(), m_layers), width, height, image, task.stop)
                 : Status(frame.error());
}

} // namespace fumage
