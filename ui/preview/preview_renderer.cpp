#include "ui/preview/preview_renderer.h"

#include "ui/preview/air_arrows.h"
#include "ui/preview/seen_layer.h"
#include "ui/preview/sprite_snapshot.h"
#include "ui/preview/trails.h"

#include "core/rendering/scene_renderer.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <QElapsedTimer>

namespace fumage::ui {

namespace {

constexpr double kUnknownShare = -1.0;

constexpr int kCheckerPixels = 16;

/// What is seen behind the smoke in the window.
Backing backingOf(const Backdrop& backdrop, const Output& output)
{
    if (output.background == Background::Colour) {
        return {output.backgroundColour};
    }
    constexpr glm::vec3 kDark(0.10F);
    constexpr glm::vec3 kLight(0.16F);
    return backdrop.kind == Backdrop::Kind::Colour ? Backing{backdrop.colour} : Backing{kDark, kLight, kCheckerPixels};
}

double particleSteps(const std::vector<LayerWork>& layers)
{
    return std::accumulate(layers.begin(), layers.end(), 0.0,
        [](double sum, const LayerWork& layer) { return sum + layer.particleSteps; });
}

/// What is drawn of the particles of a frame.
SceneFrame drawnFrame(const PicturePlan& plan, const SceneFrame& frame)
{
    SceneFrame drawn = frame;
    for (std::size_t layer = 0; layer < plan.sparse.size(); ++layer) {
        const double share = static_cast<double>(plan.sparse[layer]->emitter.count) / plan.layers[layer]->emitter.count;
        if (share < 1.0) {
            drawn.layers[layer] = std::make_shared<const Frame>(sparse(*frame.layers[layer], share));
        }
    }
    return drawn;
}

/// The same that nobody sees.
SampledEffect transparent(const SampledEffect& effect)
{
    Effect nothing = effect;
    nothing.look.opacity = 0.0F;
    return sampled(nothing);
}

QImage toScreen(const EncodedImage<std::uint8_t>& encoded)
{
    const QImage view(encoded.pixels.data(), encoded.width, encoded.height, encoded.width * 4, QImage::Format_RGBX8888);
    return view.convertToFormat(QImage::Format_RGB32);
}

} // namespace

PreviewRenderer::PreviewRenderer(std::shared_ptr<AirCache> shelf, WorkListener listener)
    : m_shelf(std::move(shelf))
    , m_listener(std::move(listener))
    , m_planner(m_shelf)
{
}

void PreviewRenderer::takePrepared(const RenderRequest& request, const Plan& plan)
{
    const RunningSimulator* complete = m_planner.simulators().complete(plan);
    if (request.prepared && request.previewQuality == PreviewQuality::Playback && plan.keepsAll
        && !(complete != nullptr && complete->hasBegun)) {
        m_planner.simulators().take(plan, std::move(*request.prepared));
    }
}

void PreviewRenderer::noteTrouble(const Error& error)
{
    if (error.code != ErrorCode::Cancelled) {
        m_trouble = error;
    }
}

/// Before particles are timed: what they cost does not depend on whether their air is there.
bool PreviewRenderer::bakeAir(const Plan& plan, int frame, Picture& picture, const std::stop_token& stop)
{
    const SimulationModel& model = m_planner.simulators().runningFor(plan).simulator.model();
    const std::int64_t last = model.airStep(model.schedule().stepOfFrame(frame));
    if (model.air() == nullptr || model.air()->isBaked(last)) {
        return true;
    }
    QElapsedTimer timer;
    timer.start();
    const Status status = model.air()->bake(last, stop, [this](double share) { m_listener(Phase::Air, share); });
    picture.bakeNs = timer.nsecsElapsed();
    return status.ok();
}

/// What is drawn over the smoke where it was asked for.
void PreviewRenderer::addOverlays(
    const RenderRequest& request, const Plan& plan, Picture& picture, const std::stop_token& stop)
{
    if (request.trails) {
        Scene scene = *request.scene;
        scene.air.resolution = plan.layers.front()->air.resolution; // of the stand-in, where there is one
        picture.trails = findTrails(scene, request.layer, request.frame, m_shelf);
    }
    const SimulationModel& model = m_planner.simulators().runningFor(plan).simulator.model();
    if (request.air && model.air() != nullptr) {
        if (const auto field = model.air()->field(model.airStep(model.schedule().stepOfFrame(request.frame)), stop)) {
            picture.air = findAirArrows(*field.value(), request.scene->layers[request.layer].emitter.position,
                windowView(*request.scene, request.frame, request.width, request.height).forward);
        }
    }
}

std::optional<SceneFrame> PreviewRenderer::simulate(const Plan& plan, int frame, const std::stop_token& stop)
{
    RunningSimulator& running = m_planner.simulators().runningFor(plan);
    const auto progress = [this](ProgressPhase work, int done, int total) {
        m_listener(
            work == ProgressPhase::Air ? Phase::Air : Phase::Steps, static_cast<double>(done) / std::max(1, total));
    };
    m_listener(Phase::Steps, kUnknownShare);
    Result<SceneFrame> result = running.simulator.frame(frame, {progress, stop});
    if (!result) {
        noteTrouble(result.error());
        return std::nullopt;
    }
    running.hasBegun = true;
    return std::move(result).value();
}

std::vector<LayerWork> PreviewRenderer::workOf(const RenderRequest& request, const Plan& plan)
{
    const SceneSimulator& simulator = m_planner.simulators().runningFor(plan).simulator;
    const std::vector<std::size_t> visible = request.scene->visibleLayers();
    std::vector<LayerWork> work;
    for (std::size_t i = 0; i < visible.size(); ++i) {
        work.push_back({visible[i], plan.layers[i]->emitter.count, simulator.particleSteps(i, request.frame)});
    }
    return work;
}

/// Light and sprites of what is drawn; where that is nothing, of a layer that nobody sees: a picture has a camera.
Status PreviewRenderer::prepare(
    const RenderRequest& request, const Plan& plan, const SceneFrame& frame, const std::stop_token& stop)
{
    const auto scaled = [&](int edge) { return std::max(1, static_cast<int>(std::lround(edge * plan.scale))); };
    const View view = windowView(*request.scene, request.frame, scaled(request.width), scaled(request.height));
    m_renderer.setPhaseMix(plan.phaseMix);
    const LayersAtFrame all(frame, plan.looks());
    const std::vector<std::size_t> visible = request.scene->visibleLayers();
    std::vector<LayerFrame> drawn;
    m_drawn.clear();
    for (const std::size_t layer : plan.drawn) {
        drawn.push_back(all.frames()[layer]);
        if (layer < visible.size()) {
            m_drawn.push_back(visible[layer]);
        }
    }
    if (drawn.empty()) {
        const SampledEffect nothing = transparent(all.surroundings());
        const LayerFrame layer{all.frames().front().frame, &nothing};
        return m_renderer.prepare({&layer, 1}, view, stop);
    }
    return m_renderer.prepare(drawn, view, stop);
}

bool PreviewRenderer::paint(
    const RenderRequest& request, const Plan& plan, Picture& picture, const std::stop_token& stop)
{
    if (request.sprites) {
        picture.sprites = snapshotOf(m_renderer);
        return true;
    }
    if (const Status status = m_renderer.composite(m_image, stop); !status) {
        noteTrouble(status.error());
        return false;
    }
    const Output output = plan.layers.front().atFrame(request.frame)->output;
    encodeOver(m_image, output, backingOf(request.backdrop, output), m_encoded);
    picture.image = toScreen(m_encoded);
    return true;
}

PicturePtr PreviewRenderer::make(const RenderRequest& request, const std::stop_token& stop)
{
    PicturePtr picture = lastPicked(request);
    if (picture == nullptr) {
        m_last.reset();
        picture = makePicture(request, stop);
        m_last = picture;
    }
    m_listener(Phase::Idle, 1.0);
    return picture;
}

PicturePtr PreviewRenderer::lastPicked(const RenderRequest& request) const
{
    const bool isSame = request.pick.number != 0 && m_last && m_last->revision == request.revision
        && m_last->frame == request.frame && (m_last->complete || request.previewQuality != PreviewQuality::Full);
    if (!isSame) {
        return nullptr;
    }
    auto picture = std::make_shared<Picture>(*m_last);
    picture->picked = layerSeenAt(request.pick, m_renderer, m_drawn);
    return picture;
}

PicturePtr PreviewRenderer::makePicture(const RenderRequest& request, const std::stop_token& stop)
{
    const Plan plan = m_planner.planFor(request);
    takePrepared(request, plan);
    auto picture = std::make_shared<Picture>();
    m_trouble.reset();
    if (!bakeAir(plan, request.frame, *picture, stop)) {
        return nullptr;
    }
    picture->layers = workOf(request, plan);
    QElapsedTimer timer;
    timer.start();
    const std::optional<SceneFrame> frame = simulate(plan, request.frame, stop);
    if (!frame) {
        return nullptr;
    }
    picture->stepNs = timer.nsecsElapsed();
    m_planner.costs().noteSteps(particleSteps(picture->layers), picture->stepNs);

    const int particles = plan.drawnParticles();
    timer.restart();
    m_listener(Phase::Light, kUnknownShare);
    const SceneFrame drawn = drawnFrame(plan, *frame);
    if (const Status status = prepare(request, plan, drawn, stop); !status) {
        noteTrouble(status.error());
        return nullptr;
    }
    m_planner.costs().noteSprites(particles, timer.nsecsElapsed());
    timer.restart();
    m_listener(Phase::Paint, kUnknownShare);
    if (!paint(request, plan, *picture, stop)) {
        return nullptr;
    }
    m_planner.costs().notePixels(plan.scale * plan.scale * request.width * request.height, timer.nsecsElapsed());

    picture->picked = layerSeenAt(request.pick, m_renderer, m_drawn);
    addOverlays(request, plan, *picture, stop);
    picture->output = plan.layers.front().atFrame(request.frame)->output;
    picture->backdrop = request.backdrop;
    picture->revision = request.revision;
    picture->frame = request.frame;
    picture->complete = plan.complete;
    picture->thinned = !plan.keepsAll || !plan.sparse.empty();
    picture->coarseAir = plan.coarseAir;
    picture->particles = particles;
    picture->times = m_renderer.times();
    return picture;
}

} // namespace fumage::ui
