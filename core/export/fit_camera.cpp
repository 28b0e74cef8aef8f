#include "core/export/fit_camera.h"

#include "core/base/memory.h"
#include "core/rendering/framing.h"
#include "core/rendering/scene_renderer.h"

#include <algorithm>
#include <cmath>

namespace fumage {

namespace {

/// Edge of the pictures that are looked at, the longer one; those beyond the whole rounds of the animation are looked
/// at only where smoke was still cut off.
constexpr int kEdge = 256;
constexpr int kRounds = 2;
constexpr int kMaxRounds = 4;
/// Of the frames that give the first guess one in so many is looked at.
constexpr int kStride = 4;
/// Half of what may be on the border at most.
constexpr float kSeen = 0.5F / 255.0F;

/// Looks at all frames of an effect, from a camera that comes nearer to what is wanted each time.
class Fitting {
public:
    Fitting(const Scene& scene, const FrameRange& frames, const Task& task)
        : m_layers(layersOf(scene))
        , m_simulator(m_layers)
        , m_frames(frames)
        , m_task(task)
    {
        const float scale =
            static_cast<float>(kEdge) / static_cast<float>(std::max(scene.output.width, scene.output.height));
        m_width = std::max(1, static_cast<int>(std::lround(static_cast<float>(scene.output.width) * scale)));
        m_height = std::max(1, static_cast<int>(std::lround(static_cast<float>(scene.output.height) * scale)));
        m_guesses = (frames.count() + kStride - 1) / kStride;
    }

    Result<Camera> run()
    {
        const Camera& asked = m_layers.front()->camera;
        Framing guess(asked, m_width, m_height);
        for (int index = 0; index < m_frames.count(); index += kStride) {
            const auto frame = m_simulator.frame(m_frames.at(index), m_task);
            if (!frame) {
                return frame.error();
            }
            const LayersAtFrame layers(frame.value(), m_layers);
            for (const LayerFrame& layer : layers.frames()) {
                findAppearance(*layer.frame, *layer.effect, Axes{}, m_appearance);
                guess.addParticles(layer.frame->particles, m_appearance, secondsAt(frame.value()));
            }
            report();
        }
        Camera camera = guess.camera();
        for (int round = 0; round < kMaxRounds && (round < kRounds || m_touches); ++round) {
            Framing seen(asked, m_width, m_height);
            if (Status status = look(camera, seen); !status) {
                return status.error();
            }
            if (seen.isEmpty()) {
                return Error{ErrorCode::OutOfRange,
                    makeMessage("no visible smoke in frames %1 to %2", m_frames.first, m_frames.last), {},
                    makeMessage("Choose other frames, or make the smoke denser")};
            }
            camera = seen.camera();
        }
        return camera;
    }

private:
    /// Light has no part in where smoke is.
    static std::vector<SampledEffect> layersOf(Scene scene)
    {
        scene.output.quality = Quality::Good;
        scene.light.shadow = 0.0F;
        scene.light.occlusion = 0.0F;
        return sampledLayers(scene);
    }

    [[nodiscard]] float secondsAt(const SceneFrame& frame) const
    {
        return secondsOf(m_layers.front()->timeline, frame.layers.front()->number);
    }

    void report()
    {
        const int total = m_guesses + kRounds * m_frames.count();
        m_done = std::min(m_done + 1, total);
        m_task.progress(ProgressPhase::Fitting, m_done, total);
    }

    /// Renders every frame through a camera, and adds where smoke was seen.
    Status look(const Camera& camera, Framing& seen)
    {
        m_touches = false;
        for (int index = 0; index < m_frames.count(); ++index) {
            const auto frame = m_simulator.frame(m_frames.at(index), m_task);
            if (!frame) {
                return frame.error();
            }
            const float seconds = secondsAt(frame.value());
            const View view = makeView(camera, seconds, m_width, m_height);
            if (Status status = m_renderer.prepare(LayersAtFrame(frame.value(), m_layers), view, m_task.stop);
                !status) {
                return status;
            }
            if (Status status = m_renderer.composite(m_image, m_task.stop); !status) {
                return status;
            }
            const PictureReach reach = reachOf(m_image, kSeen);
            m_touches = m_touches
                || (!reach.isEmpty()
                    && (reach.left == 0 || reach.top == 0 || reach.right == m_width || reach.bottom == m_height));
            seen.addPicture(view, reach, depths(frame.value(), view), seconds);
            report();
        }
        return Done{};
    }

    /// Of what is drawn, m.
    [[nodiscard]] DepthRange depths(const SceneFrame& frame, const View& view) const
    {
        Depths found;
        for (std::size_t layer = 0; layer < frame.layers.size(); ++layer) {
            const Particles& particles = frame.layers[layer]->particles;
            const SpriteBatch& batch = m_renderer.batch(layer);
            for (std::size_t i = 0; i < particles.capacity; ++i) {
                if (batch.depth[i] == SpriteBatch::kHidden || batch.sprites[i].opacity < kSeen) {
                    continue;
                }
                const float depth = project(view, {particles.x[i], particles.y[i], particles.z[i]}).depth;
                found.add(depth, batch.sprites[i].opacity * batch.sprites[i].halfWidth * batch.sprites[i].halfHeight);
            }
        }
        return found.isEmpty() ? DepthRange{1.0F, 1.0F, 1.0F} : found.range();
    }

    std::vector<SampledEffect> m_layers;
    SceneSimulator m_simulator;
    Renderer m_renderer;
    Appearance m_appearance;
    Image m_image;
    FrameRange m_frames;
    const Task& m_task;
    int m_width = 1;
    int m_height = 1;
    int m_guesses = 0;
    int m_done = 0;
    bool m_touches = false;
};

} // namespace

Result<Camera> fitCamera(const Scene& scene, const FrameRange& frames, const Task& task)
{
    return withinMemory([&] { return Fitting(scene, frames, task).run(); });
}

} // namespace fumage
