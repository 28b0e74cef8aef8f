#include "core/export/fit_camera.h"

#include "core/base/memory.h"
#include "core/export/smoke_tally.h"
#include "core/rendering/framing.h"
#include "core/rendering/scene_renderer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/vec3.hpp>

namespace fumage {

namespace {

/// Edge of the pictures that are looked at, the longer one; those beyond the whole rounds of the animation are looked
/// at only where smoke was still cut off.
constexpr int kEdge = 256;
constexpr int kRounds = 2;
constexpr int kMaxRounds = 4;
/// Rounds without outliers: from where all is seen the rest is small, and the first comes as near as that is known.
constexpr int kOutlierRounds = 3;
/// Of the frames that give the first guess one in so many is looked at, where that leaves enough of them.
constexpr std::size_t kStride = 4;
constexpr std::size_t kMinFrames = 16;
/// Half of what may be on the border at most.
constexpr float kSeen = 0.5F / 255.0F;
constexpr double kPercent = 0.01;
constexpr double kMaxShare = kPercent * static_cast<double>(kMaxOutlierPercent);

/// Finds the middle of smoke, each particle by what it covers.
class MiddleOfSmoke {
public:
    void add(const Particles& particles, const Appearance& appearance)
    {
        for (std::size_t i = 0; i < particles.capacity; ++i) {
            if (!(appearance.alpha[i] > 0.0F && appearance.radius[i] > 0.0F)) {
                continue;
            }
            const auto radius = static_cast<double>(appearance.radius[i]);
            const double weight = static_cast<double>(appearance.alpha[i]) * radius * radius;
            m_sum += weight * glm::dvec3(particles.x[i], particles.y[i], particles.z[i]);
            m_weight += weight;
        }
    }
    [[nodiscard]] bool isEmpty() const { return !(m_weight > 0.0); }
    /// Of at least one particle.
    [[nodiscard]] glm::vec3 point() const { return {m_sum / m_weight}; }

private:
    glm::dvec3 m_sum{0.0};
    double m_weight = 0.0;
};

/// Looks at frames of an effect, from a camera that comes nearer to what is wanted each time.
class Fitting {
public:
    /// @param share of the smoke that may be outside, 0 to kMaxShare
    Fitting(const Scene& scene, std::span<const int> frames, const ExportTask& task, double share)
        : m_layers(layersOf(scene))
        , m_simulator(m_layers, Simulator::kDefaultCheckpointBytes, task.shelf)
        , m_frames(frames)
        , m_stride(std::clamp(frames.size() / kMinFrames, std::size_t{1}, kStride))
        , m_task(task)
        , m_share(share)
    {
        const float scale =
            static_cast<float>(kEdge) / static_cast<float>(std::max(scene.output.width, scene.output.height));
        m_width = std::max(1, static_cast<int>(std::lround(static_cast<float>(scene.output.width) * scale)));
        m_height = std::max(1, static_cast<int>(std::lround(static_cast<float>(scene.output.height) * scale)));
        const int count = static_cast<int>(frames.size());
        m_total = static_cast<int>((frames.size() + m_stride - 1) / m_stride)
            + (kRounds + (m_share > 0.0 ? kOutlierRounds : 0)) * count;
    }

    Result<Camera> run()
    {
        const Camera& asked = m_layers.front()->camera;
        Framing guess(asked, m_width, m_height);
        if (Status status = guessFromParticles(guess); !status) {
            return status.error();
        }
        Camera camera = guess.camera();
        for (int round = 0; round < kMaxRounds && (round < kRounds || m_touches); ++round) {
            Framing seen(asked, m_width, m_height);
            if (Status status = look(camera, seen); !status) {
                return status.error();
            }
            if (seen.isEmpty()) {
                return Error{ErrorCode::OutOfRange,
                    makeMessage("no visible smoke in frames %1 to %2", m_frames.front(), m_frames.back()), {},
                    makeMessage("Choose other frames, or make the smoke denser")};
            }
            camera = seen.camera();
            guess = std::move(seen);
        }
        return m_share > 0.0 ? withoutOutliers(aroundTheMiddle(camera, guess)) : camera;
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
        m_done = std::min(m_done + 1, m_total);
        m_task.progress(ProgressPhase::Fitting, m_done, m_total);
    }

    Status guessFromParticles(Framing& guess)
    {
        for (std::size_t index = 0; index < m_frames.size(); index += m_stride) {
            const auto frame = m_simulator.frame(m_frames[index], m_task);
            if (!frame) {
                return frame.error();
            }
            const LayersAtFrame layers(frame.value(), m_layers);
            for (const LayerFrame& layer : layers.frames()) {
                findAppearance(*layer.frame, *layer.effect, Axes{}, m_appearance);
                guess.addParticles(layer.frame->particles, m_appearance, secondsAt(frame.value()));
                m_middle.add(layer.frame->particles, m_appearance);
            }
            report();
        }
        return Done{};
    }

    /// Renders the frames through a camera.
    /// @param take is given the frame and its view when m_image and m_renderer have its picture
    template <class Take>
    Status lookThrough(const Camera& camera, Take take)
    {
        for (const int number : m_frames) {
            const auto frame = m_simulator.frame(number, m_task);
            if (!frame) {
                return frame.error();
            }
            const View view = makeView(camera, secondsAt(frame.value()), m_width, m_height);
            if (Status status = m_renderer.prepare(LayersAtFrame(frame.value(), m_layers), view, m_task.stop);
                !status) {
                return status;
            }
            if (Status status = m_renderer.composite(m_image, m_task.stop); !status) {
                return status;
            }
            take(frame.value(), view);
            report();
        }
        return Done{};
    }

    /// Adds where smoke is seen through a camera.
    Status look(const Camera& camera, Framing& seen)
    {
        m_touches = false;
        return lookThrough(camera, [&](const SceneFrame& frame, const View& view) {
            const PictureReach reach = reachOf(m_image, kSeen);
            m_touches = m_touches
                || (!reach.isEmpty()
                    && (reach.left == 0 || reach.top == 0 || reach.right == m_width || reach.bottom == m_height));
            seen.addPicture(view, reach, depths(frame, view), secondsAt(frame));
        });
    }

    /// Where all is seen as well, on a turntable with the smoke in the middle: there it stays while what has flown off
    /// goes around it.
    /// @param seen all that the camera sees
    [[nodiscard]] Camera aroundTheMiddle(Camera camera, const Framing& seen) const
    {
        if (camera.mode == CameraMode::Orbit && camera.turntable != 0.0F && !m_middle.isEmpty()) {
            camera.target = m_middle.point();
            camera.distance = seen.distanceFrom(camera.target);
        }
        return camera;
    }

    /// Comes nearer by leaving outliers outside. What lies beyond the margins after a round is what that round has left
    /// outside, and counts no more.
    /// @param camera sees all
    Result<Camera> withoutOutliers(Camera camera)
    {
        struct Moment {
            View view;
            DepthRange depths;
            float seconds;
        };
        double share = m_share; // of what is still inside
        for (int round = 0; round < kOutlierRounds; ++round) {
            SmokeTally tally(m_width, m_height, kSeen);
            DepthTally along;
            std::vector<Moment> moments;
            const Status status = lookThrough(camera, [&](const SceneFrame& frame, const View& view) {
                tally.add(m_image);
                moments.push_back({view, depths(frame, view), secondsAt(frame)});
                forEachSprite(frame, view, [&](float depth, const Sprite& sprite) {
                    const auto size = static_cast<double>(depth); // what it covers where it is, near or far
                    along.add(depth, static_cast<double>(coverOf(sprite)) * size * size);
                });
            });
            if (!status) {
                return status.error();
            }
            Framing kept(camera, m_width, m_height);
            const OutlierCut cut = cutOutliers(tally, round == 0 ? tally.whole() : kept.inner(), share, kMaxShare);
            share = std::max(0.0, (share - cut.lost) / (1.0 - cut.lost));
            for (std::size_t i = 0; i < moments.size(); ++i) {
                const Moment& moment = moments[i];
                kept.addPicture(
                    moment.view, tally.reachIn(i, cut.reach), along.without(moment.depths, m_share), moment.seconds);
            }
            camera = kept.camera(); // as it is where nothing is left
        }
        return camera;
    }

    static float coverOf(const Sprite& sprite) { return sprite.opacity * sprite.halfWidth * sprite.halfHeight; }

    /// Of all that are drawn, in their order.
    /// @param take is given how far from the eye a particle is, m, and its sprite
    template <class Take>
    void forEachSprite(const SceneFrame& frame, const View& view, Take take) const
    {
        for (std::size_t layer = 0; layer < frame.layers.size(); ++layer) {
            const Particles& particles = frame.layers[layer]->particles;
            const SpriteBatch& batch = m_renderer.batch(layer);
            for (std::size_t i = 0; i < particles.capacity; ++i) {
                if (batch.depth[i] == SpriteBatch::kHidden || batch.sprites[i].opacity < kSeen) {
                    continue;
                }
                take(project(view, {particles.x[i], particles.y[i], particles.z[i]}).depth, batch.sprites[i]);
            }
        }
    }

    /// Of what is drawn, m.
    [[nodiscard]] DepthRange depths(const SceneFrame& frame, const View& view) const
    {
        Depths found;
        forEachSprite(frame, view, [&found](float depth, const Sprite& sprite) { found.add(depth, coverOf(sprite)); });
        return found.isEmpty() ? DepthRange{1.0F, 1.0F, 1.0F} : found.range();
    }

    std::vector<SampledEffect> m_layers;
    SceneSimulator m_simulator;
    Renderer m_renderer;
    Appearance m_appearance;
    MiddleOfSmoke m_middle;
    Image m_image;
    std::span<const int> m_frames;
    std::size_t m_stride; ///< of the frames that give the first guess
    const Task& m_task;
    double m_share;
    int m_width = 1;
    int m_height = 1;
    int m_total = 0; ///< frames to be looked at
    int m_done = 0;
    bool m_touches = false;
};

} // namespace

Result<Camera> fitCamera(const Scene& scene, std::span<const int> frames, float outliers, const ExportTask& task)
{
    const double share = outliers > 0.0F ? std::min(kPercent * static_cast<double>(outliers), kMaxShare) : 0.0;
    return withinMemory([&] { return Fitting(scene, frames, task, share).run(); });
}

} // namespace fumage
