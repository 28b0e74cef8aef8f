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

/// Time for a picture while the hand moves: 30 frames/s, less what the screen needs.
constexpr qint64 kBudgetNs = 28'000'000;
/// Share of it that particles may take; the rest is for pixels.
constexpr qint64 kParticleBudgetNs = kBudgetNs * 3 / 4;

/// In which a picture that needs a pre-roll is still said to come at once.
constexpr qint64 kSoonNs = 400'000'000;

constexpr double kUnknownShare = -1.0;

constexpr int kCoarseAir = 20; ///< cells: some tens of milliseconds for two hundred steps

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
    , m_simulators(m_shelf)
{
}

int PreviewRenderer::particlesWhileDragging(const Plan& plan, double preRoll) const
{
    const int all = plan.particles;
    if (all <= m_costs.particlesWithin(kParticleBudgetNs, plan.stepsEach, plan.drawnShare())) {
        return all;
    }
    // A drag of the look keeps the particles that its first picture has chosen.
    const std::optional<RunningSimulator>& thinned = m_simulators.thinned();
    if (thinned && thinned->simulation == plan.simulation && thinned->particles < all) {
        return thinned->particles;
    }
    return CostEstimate::halvedInto(all, m_costs.particlesWithin(kParticleBudgetNs, preRoll, plan.drawnShare()));
}

int PreviewRenderer::particlesToSettle(int all, double preRoll) const
{
    const int affordable = m_costs.particlesWithin(kSoonNs, preRoll);
    // Where the whole is not far off, it comes at once.
    constexpr int kNear = 3;
    if (all / kNear <= affordable) {
        return all;
    }
    return CostEstimate::halvedInto(all, affordable);
}

int PreviewRenderer::particlesToPlay(const Plan& plan, double preRoll, double stepsAFrame) const
{
    // Those that have begun go on: a new pre-roll for others would be seen.
    const std::optional<RunningSimulator>& settling = m_simulators.settling();
    if (settling && settling->simulation == plan.simulation && settling->coarseAir == plan.coarseAir
        && settling->particles <= plan.particles) {
        return settling->particles;
    }
    const int soon = m_costs.particlesWithin(kSoonNs, preRoll);
    return CostEstimate::halvedInto(
        plan.particles, std::min(soon, m_costs.particlesWithin(kParticleBudgetNs, stepsAFrame)));
}

bool PreviewRenderer::lacksAir(const RenderRequest& request, const Plan& plan, const Schedule& schedule) const
{
    const Air& air = plan.layers.front()->air;
    if (!air.enabled || air.resolution <= kCoarseAir
        || (request.previewQuality != PreviewQuality::Interactive && request.previewQuality != PreviewQuality::Playback
            && request.mayBake)) {
        return false;
    }
    const std::int64_t missing = m_shelf->missingSteps(plan.layers, request.frame);
    // The steps of one frame come with it.
    const bool areFew = request.previewQuality == PreviewQuality::Playback && request.mayBake
        && missing <= 2 * schedule.stepsPerFrame + 1;
    return missing > 0 && !areFew;
}

bool PreviewRenderer::isSlowToBegin(const RenderRequest& request, const Plan& plan) const
{
    const RunningSimulator* complete = m_simulators.complete(plan);
    const bool hasBegun = (complete != nullptr && complete->hasBegun) || request.prepared;
    return request.previewQuality == PreviewQuality::Playback && !hasBegun
        && m_costs.particlesWithin(kSoonNs, plan.stepsEach) < plan.particles;
}

void PreviewRenderer::scaleDown(const RenderRequest& request, Quality quality, Plan& plan) const
{
    const double pixels = static_cast<double>(request.width) * request.height;
    plan.scale = m_costs.scaleWithin(kBudgetNs, plan.particles, plan.stepsEach, pixels, plan.drawnShare());
    plan.phaseMix = PhaseMix::Choose;
    plan.complete = plan.keepsAll && plan.scale == 1.0 && quality == request.scene->output.quality
        && std::none_of(
            plan.layers.begin(), plan.layers.end(), [](const SampledEffect& layer) { return hasDetail(layer); });
}

PreviewRenderer::Plan PreviewRenderer::planFor(const RenderRequest& request)
{
    Scene asked = *request.scene;
    if (request.previewQuality != PreviewQuality::Full) {
        // What the final quality adds would cost the motion more than it gives.
        asked.output.quality = std::min(asked.output.quality, Quality::Good);
    }
    Plan plan(asked, request.solo);
    plan.simulation = request.simulation;
    const Schedule schedule = plan.longestSchedule();
    plan.coarseAir = lacksAir(request, plan, schedule);
    if (plan.coarseAir) {
        asked.air.resolution = kCoarseAir;
        plan.takeLayersOf(asked);
    } else if (asked.output.quality == request.scene->output.quality) {
        m_simulators.renew(plan);
    }
    // Particles are of all ages: a pre-roll takes half a life each.
    const double preRoll = 0.5 * static_cast<double>(schedule.lifetimeSteps);
    const int all = plan.particles;
    const auto thinTo = [&](int count) {
        plan.keepsAll = count == all && !plan.coarseAir;
        plan.thinTo(count);
        plan.stepsEach = m_simulators.stepsEach(plan, request.frame, preRoll);
    };
    plan.stepsEach = m_simulators.stepsEach(plan, request.frame, preRoll);
    switch (request.previewQuality) {
    case PreviewQuality::Full:
        plan.settles = plan.coarseAir;
        plan.keepsAll = !plan.coarseAir;
        plan.complete = plan.keepsAll;
        break;
    case PreviewQuality::Intermediate:
        plan.settles = true;
        thinTo(particlesToSettle(all, preRoll));
        plan.complete = plan.keepsAll && asked.output.quality == request.scene->output.quality;
        break;
    case PreviewQuality::Interactive:
        thinTo(particlesWhileDragging(plan, preRoll));
        scaleDown(request, asked.output.quality, plan);
        break;
    case PreviewQuality::Playback:
        if (plan.coarseAir || isSlowToBegin(request, plan)) {
            plan.settles = true;
            thinTo(particlesToPlay(plan, preRoll, static_cast<double>(schedule.stepsPerFrame)));
        }
        scaleDown(request, asked.output.quality, plan);
        break;
    }
    return plan;
}

void PreviewRenderer::takePrepared(const RenderRequest& request, const Plan& plan)
{
    const RunningSimulator* complete = m_simulators.complete(plan);
    if (request.prepared && request.previewQuality == PreviewQuality::Playback && plan.keepsAll
        && !(complete != nullptr && complete->hasBegun)) {
        m_simulators.take(plan, std::move(*request.prepared));
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
    const SimulationModel& model = m_simulators.runningFor(plan).simulator.model();
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
    const SimulationModel& model = m_simulators.runningFor(plan).simulator.model();
    if (request.air && model.air() != nullptr) {
        if (const auto field = model.air()->field(model.airStep(model.schedule().stepOfFrame(request.frame)), stop)) {
            picture.air = findAirArrows(*field.value(), request.scene->layers[request.layer].emitter.position,
                windowView(*request.scene, request.frame, request.width, request.height).forward);
        }
    }
}

std::optional<SceneFrame> PreviewRenderer::simulate(const Plan& plan, int frame, const std::stop_token& stop)
{
    RunningSimulator& running = m_simulators.runningFor(plan);
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
    const SceneSimulator& simulator = m_simulators.runningFor(plan).simulator;
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
    const LayersAtFrame all(frame, plan.layers);
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
    const Plan plan = planFor(request);
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
    m_costs.noteSteps(particleSteps(picture->layers), picture->stepNs);

    const int particles = static_cast<int>(std::lround(plan.particles * plan.drawnShare()));
    timer.restart();
    m_listener(Phase::Light, kUnknownShare);
    if (const Status status = prepare(request, plan, *frame, stop); !status) {
        noteTrouble(status.error());
        return nullptr;
    }
    m_costs.noteSprites(particles, timer.nsecsElapsed());
    timer.restart();
    m_listener(Phase::Paint, kUnknownShare);
    if (!paint(request, plan, *picture, stop)) {
        return nullptr;
    }
    m_costs.notePixels(plan.scale * plan.scale * request.width * request.height, timer.nsecsElapsed());

    picture->picked = layerSeenAt(request.pick, m_renderer, m_drawn);
    addOverlays(request, plan, *picture, stop);
    picture->output = plan.layers.front().atFrame(request.frame)->output;
    picture->backdrop = request.backdrop;
    picture->revision = request.revision;
    picture->frame = request.frame;
    picture->complete = plan.complete;
    picture->thinned = !plan.keepsAll;
    picture->coarseAir = plan.coarseAir;
    picture->particles = particles;
    picture->times = m_renderer.times();
    return picture;
}

} // namespace fumage::ui
