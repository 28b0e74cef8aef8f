#include "core/export/fit_camera.h"

#include "core/base/memory.h"
#include "core/rendering/framing.h"
#include "core/rendering/renderer.h"
#include "core/simulation/simulator.h"

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
    Fitting(const Effect& effect, const FrameRange& frames, const Task& task)
        : m_smoke(smokeOf(effect))
        , m_simulator(m_smoke)
        , m_frames(frames)
        , m_task(task)
    {
        const float scale =
            static_cast<float>(kEdge) / static_cast<float>(std::max(effect.output.width, effect.output.height));
        m_width = std::max(1, static_cast<int>(std::lround(static_cast<float>(effect.output.width) * scale)));
        m_height = std::max(1, static_cast<int>(std::lround(static_cast<float>(effect.output.height) * scale)));
        m_guesses = (frames.count() + kStride - 1) / kStride;
    }

    Result<Camera> run()
    {
        const Camera& asked = m_smoke->camera;
        Framing guess(asked, m_width, m_height);
        for (int index = 0; index < m_frames.count(); index += kStride) {
            const auto frame = m_simulator.frame(m_frames.at(index), m_task);
            if (!frame) {
                return frame.error();
            }
            findAppearance(*frame.value(), m_smoke, Axes{}, m_appearance);
            guess.addParticles(
                frame.value()->particles, m_appearance, secondsOf(m_smoke->timeline, frame.value()->number));
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
    static SampledEffect smokeOf(Effect effect)
    {
        effect.output.quality = Quality::Good;
        effect.light.shadow = 0.0F;
        effect.light.occlusion = 0.0F;
        return sampled(effect);
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
            const float seconds = secondsOf(m_smoke->timeline, frame.value()->number);
            const View view = makeView(camera, seconds, m_width, m_height);
            if (Status status = m_renderer.prepare(*frame.value(), m_smoke, view, m_task.stop); !status) {
                return status;
            }
            if (Status status = m_renderer.composite(m_image, m_task.stop); !status) {
                return status;
            }
            const PictureReach reach = reachOf(m_image, kSeen);
            m_touches = m_touches
                || (!reach.isEmpty()
                    && (reach.left == 0 || reach.top == 0 || reach.right == m_width || reach.bottom == m_height));
            seen.addPicture(view, reach, depths(frame.value()->particles, view), seconds);
            report();
        }
        return Done{};
    }

    /// Of what is drawn, m.
    [[nodiscard]] DepthRange depths(const Particles& particles, const View& view) const
    {
        const SpriteBatch& batch = m_renderer.batch();
        Depths found;
        for (std::size_t i = 0; i < particles.capacity; ++i) {
            if (batch.depth[i] == SpriteBatch::kHidden || batch.sprites[i].opacity < kSeen) {
                continue;
            }
            const float depth = project(view, {particles.x[i], particles.y[i], particles.z[i]}).depth;
            found.add(depth, batch.sprites[i].opacity * batch.sprites[i].halfWidth * batch.sprites[i].halfHeight);
        }
        return found.isEmpty() ? DepthRange{1.0F, 1.0F, 1.0F} : found.range();
    }

    SampledEffect m_smoke;
    Simulator m_simulator;
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

Result<Camera> fitCamera(const Effect& effect, const FrameRange& frames, const Task& task)
{
    return withinMemory([&] { return Fitting(effect, frames, task).run(); });
}

} // namespace fumage
