#include "core/export/sheets/trim.h"

#include "core/rendering/pass_renderer.h"
#include "core/rendering/view_transform.h"
#include "core/simulation/scene_simulator.h"

#include <algorithm>

namespace fumage {

namespace {

/// Looks for smoke in frames.
class SmokeWatch {
public:
    SmokeWatch(const Scene& scene, int total, const ExportTask& task)
        : m_scene(scene)
        , m_layers(sampledLayers(scene))
        , m_simulator(m_layers, Simulator::kDefaultCheckpointBytes, task.shelf)
        , m_total(total)
        , m_task(task)
    {
    }

    [[nodiscard]] Result<bool> isEmpty(int number)
    {
        const Result<SceneFrame> frame = m_simulator.frame(number, m_task);
        if (!frame) {
            return frame.error();
        }
        FrameAmongOthers alone;
        for (std::size_t layer = 0; layer < m_layers.size(); ++layer) {
            alone.layers.push_back({.effect = &m_layers[layer], .now = frame.value().layers[layer].get()});
        }
        const Output& cell = m_scene.output;
        if (Status status = m_renderer.render(alone, cell.width, cell.height, {Pass::Alpha}, m_images, m_task.stop);
            !status) {
            return status.error();
        }
        m_task.progress(ProgressPhase::Fitting, ++m_done, m_total);
        return !showsSmoke(m_images.of(PassTarget::Colour), m_scene.atFrame(number));
    }

private:
    [[nodiscard]] static bool showsSmoke(const Image& image, const Scene& now)
    {
        constexpr float kSeen = 1.0F / 255.0F;
        const bool byLight = coverOf(now) == Cover::Light;
        const float gain = exposureGain(now.output.exposure);
        for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
            const float* p = image.pixels.data() + i;
            if (p[3] >= kSeen || (byLight && gain * std::max({p[0], p[1], p[2]}) >= kSeen)) {
                return true;
            }
        }
        return false;
    }

    const Scene& m_scene;
    std::vector<SampledEffect> m_layers;
    SceneSimulator m_simulator;
    PassRenderer m_renderer;
    PassImages m_images;
    int m_done = 0;
    int m_total;
    const Task& m_task;
};

} // namespace

Result<FrameRange> trimmed(const Scene& scene, const FrameRange& frames, const ExportTask& task)
{
    if (scene.timeline.loop) {
        return Error{ErrorCode::OutOfRange,
            makeMessage("a loop is not trimmed: without its empty frames it would no longer close"), {},
            makeMessage("Switch the loop off, or the trimming")};
    }
    SmokeWatch watch(scene, frames.count(), task);
    const auto firstWithSmoke = [&](int from, int past, int step) -> Result<int> {
        for (int i = from; i != past; i += step) {
            const Result<bool> empty = watch.isEmpty(frames.at(i));
            if (!empty || !empty.value()) {
                return empty ? Result<int>(i) : empty.error();
            }
        }
        return past;
    };
    const Result<int> first = firstWithSmoke(0, frames.count(), 1);
    if (!first) {
        return first.error();
    }
    if (first.value() == frames.count()) {
        return Error{ErrorCode::OutOfRange,
            makeMessage("no visible smoke in frames %1 to %2", frames.first, frames.last), {},
            makeMessage("Choose other frames, or make the smoke denser")};
    }
    const Result<int> last = firstWithSmoke(frames.count() - 1, first.value(), -1);
    return last ? Result<FrameRange>(FrameRange{frames.at(first.value()), frames.at(last.value()), frames.step})
                : last.error();
}

} // namespace fumage
