#include "core/rendering/renderer.h"

#include "core/lighting/appearance.h"
#include "core/lighting/detail_light.h"
#include "core/lighting/light_grid.h"
#include "core/lighting/soft_light.h"
#include "core/rendering/sprites.h"

#include <algorithm>

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

Status Renderer::updateTexture(const Noise& noise, Layer& layer, const std::stop_token& stop)
{
    if (layer.surface.texture && layer.noise == noise) {
        return Done{};
    }
    const auto same = std::find_if(m_layers.begin(), m_layers.end(),
        [&](const std::unique_ptr<Layer>& other) { return other->surface.texture && other->noise == noise; });
    if (same != m_layers.end()) {
        layer.surface.texture = (*same)->surface.texture;
    } else {
        Result<SpriteTexture> baked = SpriteTexture::bake(noise, stop);
        if (!baked) {
            return baked.error();
        }
        layer.surface.texture = std::make_shared<const SpriteTexture>(std::move(baked).value());
    }
    layer.noise = noise;
    return Done{};
}

void Renderer::updatePicture(const Look& look, Layer& layer)
{
    const Bitmap picture = showsPicture(look) ? look.picture : Bitmap();
    if (!(layer.picture == picture)) {
        layer.surface.picture = picture.empty() ? nullptr : std::make_shared<const SpritePicture>(picture);
        layer.picture = picture;
    }
}

/// Finds where the detail of a layer is; what is the same for several layers is moved once.
Status Renderer::updateDetail(LayerFrames layers, std::size_t number, const std::stop_token& stop)
{
    Layer& layer = *m_layers[number];
    layer.detail.reset();
    const Effect& effect = *layers[number].effect;
    const Frame& frame = *layers[number].frame;
    if (!hasDetail(effect) || frame.model->air() == nullptr) {
        return Done{};
    }
    const float life = effect.look.detailLife;
    const auto own = m_layers.begin() + static_cast<std::ptrdiff_t>(number);
    const auto same = std::find_if(m_layers.begin(), own, [&](const std::unique_ptr<Layer>& other) {
        return other->detail && other->coordinates->isFor(*frame.model, life);
    });
    if (same != own) {
        layer.coordinates = (*same)->coordinates;
    } else if (!layer.coordinates
        || (layer.coordinates.use_count() > 1 && !layer.coordinates->isFor(*frame.model, life))) {
        layer.coordinates = std::make_shared<AdvectedCoordinates>();
    }
    if (Status status = layer.coordinates->moveTo(frame.model, frame.step, life, stop); !status) {
        return status;
    }
    layer.detail.emplace(effect, *layer.coordinates, m_phaseMix);
    return Done{};
}

/// How deep in smoke a cell is depends on the wave of the detail alone: found once for all layers that have the same.
void Renderer::findBodies()
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < m_lit.size(); ++i) {
        const DetailField* detail = m_lit[i].detail;
        if (detail == nullptr) {
            continue;
        }
        std::size_t same = 0;
        while (m_lit[same].detail == nullptr || m_lit[same].detail->wave != detail->wave) {
            ++same;
        }
        if (same < i) {
            m_layers[i]->body = m_layers[same]->body;
            continue;
        }
        m_bodies.resize(std::max(m_bodies.size(), count + 1));
        findBody(*detail, m_light, m_bodies[count]);
        m_layers[i]->body = count++;
    }
}

/// Finds looks and light of all layers.
Status Renderer::findSmoke(LayerFrames layers, const glm::vec3& eye)
{
    m_lit.clear();
    for (std::size_t i = 0; i < layers.size(); ++i) {
        Layer& own = *m_layers[i];
        const Effect& effect = *layers[i].effect;
        findAppearance(*layers[i].frame, *layers[i].effect, lightAxes(effect.light.direction), own.appearance,
            own.surface.texture->greys(0));
        if (Status status = checkBounds(own.appearance); !status) {
            return status;
        }
        m_lit.push_back({layers[i].frame, &effect, &own.appearance, detail(i), layers[i].effect->tracks().get()});
    }
    lightSmoke(m_lit, eye, m_lightWorkspace, m_light);
    findBodies();
    softenLight(m_light, m_lightWorkspace);
    lightByFire(m_lit, m_fireWorkspace, m_lightWorkspace, m_light);
    m_overlapWorkspace.forget();
    for (std::size_t i = 0; i < layers.size(); ++i) {
        inflateSparseParticles(
            *layers[i].frame, *layers[i].effect, m_light, m_overlapWorkspace, m_layers[i]->appearance);
    }
    return Done{};
}

Status Renderer::prepare(LayerFrames layers, const View& view, const std::stop_token& stop)
{
    m_layers.resize(layers.size());
    m_drawn.clear();
    for (std::unique_ptr<Layer>& layer : m_layers) {
        if (!layer) {
            layer = std::make_unique<Layer>();
        }
    }
    {
        const Stopwatch stopwatch(m_times.texture);
        for (std::size_t i = 0; i < layers.size(); ++i) {
            if (Status status = updateTexture((*layers[i].effect)->noise, *m_layers[i], stop); !status) {
                return status;
            }
            updatePicture((*layers[i].effect)->look, *m_layers[i]);
            if (Status status = updateDetail(layers, i, stop); !status) {
                return status;
            }
        }
    }
    {
        const Stopwatch stopwatch(m_times.light);
        if (Status status = findSmoke(layers, view.eye); !status) {
            return status;
        }
    }
    const Stopwatch stopwatch(m_times.sprites);
    m_bodies.resize(std::max<std::size_t>(m_bodies.size(), 1)); // where no layer has detail, none is looked at
    for (std::size_t i = 0; i < layers.size(); ++i) {
        Layer& own = *m_layers[i];
        makeSprites(m_lit[i], m_light, own.surface, m_bodies[own.body], view, own.batch);
        m_drawn.push_back({&own.batch, own.surface.texture.get(), own.surface.picture.get()});
    }
    return Done{};
}

Status Renderer::composite(Image& image, const std::stop_token& stop)
{
    const Stopwatch stopwatch(m_times.composite);
    return m_compositor.compose(m_drawn, image, stop);
}

Status Renderer::render(LayerFrames layers, int width, int height, Image& image, const std::stop_token& stop)
{
    const Effect& effect = *layers.front().effect;
    const int factor = effect.output.supersample;
    const View view = makeView(
        effect.camera, secondsOf(effect.timeline, layers.front().frame->number), width * factor, height * factor);
    if (Status status = prepare(layers, view, stop); !status) {
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
