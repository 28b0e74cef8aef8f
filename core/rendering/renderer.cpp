#include "core/rendering/renderer.h"

#include "core/lighting/appearance.h"
#include "core/lighting/soft_light.h"
#include "core/rendering/sprites.h"

namespace fumage {

namespace {

/// Adds the time of its life to a duration.
class Stopwatch {
public:
    explicit Stopwatch(std::chrono::nanoseconds& duration)
        : m_duration(duration)
    {
    }
    ~Stopwatch() { m_duration = std::chrono::steady_clock::now() - m_start; }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

private:
    std::chrono::nanoseconds& m_duration;
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

} // namespace

Status Renderer::updateTexture(const Noise& noise, const std::stop_token& stop)
{
    if (m_texture && m_noise == noise) {
        return Done{};
    }
    Result<SpriteTexture> baked = SpriteTexture::bake(noise, stop);
    if (!baked) {
        return baked.error();
    }
    m_texture = std::make_shared<const SpriteTexture>(std::move(baked).value());
    m_noise = noise;
    return Done{};
}

Status Renderer::updateDetail(const Frame& frame, const Effect& effect, const std::stop_token& stop)
{
    m_detail.reset();
    if (!hasDetail(effect) || frame.model->air() == nullptr) {
        return Done{};
    }
    if (!m_coordinates) {
        m_coordinates = std::make_unique<AdvectedCoordinates>();
    }
    if (Status status = m_coordinates->moveTo(frame.model, frame.step, effect.look.detailLife, stop); !status) {
        return status;
    }
    m_detail.emplace(effect, *m_coordinates, m_phaseMix);
    return Done{};
}

Status Renderer::prepare(const Frame& frame, const SampledEffect& effect, const View& view, const std::stop_token& stop)
{
    {
        const Stopwatch stopwatch(m_times.texture);
        if (Status status = updateTexture(effect->noise, stop); !status) {
            return status;
        }
        if (Status status = updateDetail(frame, effect, stop); !status) {
            return status;
        }
    }
    {
        const Stopwatch stopwatch(m_times.light);
        findAppearance(frame, effect, lightAxes(effect->light.direction), m_appearance, m_texture->greys(0));
        if (Status status = checkBounds(m_appearance); !status) {
            return status;
        }
        lightSmoke(frame, effect, m_appearance, view.eye, detail(), m_lightWorkspace, m_light);
        softenLight(m_light, m_lightWorkspace);
        lightByFire(frame, effect, m_appearance, m_fireWorkspace, m_lightWorkspace, m_light);
        inflateSparseParticles(frame, effect, m_light, m_overlapWorkspace, m_appearance);
    }
    const Stopwatch stopwatch(m_times.sprites);
    makeSprites(frame, effect, m_appearance, m_light, *m_texture, detail(), view, m_batch);
    return Done{};
}

Status Renderer::composite(Image& image, const std::stop_token& stop)
{
    const Stopwatch stopwatch(m_times.composite);
    return m_compositor.compose(m_batch, *m_texture, image, stop);
}

Status Renderer::render(
    const Frame& frame, const SampledEffect& effect, int width, int height, Image& image, const std::stop_token& stop)
{
    const int factor = effect->output.supersample;
    if (Status status = prepare(frame, effect,
            makeView(effect->camera, secondsOf(effect->timeline, frame.number), width * factor, height * factor), stop);
        !status) {
        return status;
    }
    if (Status status = composite(factor == 1 ? image : m_large, stop); !status) {
        return status;
    }
    if (factor > 1) {
        image = downsample(m_large, factor, stop);
    }
    if (stop.stop_requested()) {
        return Error{ErrorCode::Cancelled, makeMessage("the picture was cancelled"), {}, {}};
    }
    return Done{};
}

} // namespace fumage
