#include "core/live/live_scene.h"

#include "core/effect/known_parameter.h"
#include "core/live/live_changes.h"
#include "core/simulation/air_plan.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <glm/geometric.hpp>

namespace fumage {

namespace {

/// An effect as it is simulated here: endless, and from nothing.
Effect endless(const Effect& effect)
{
    Effect out = effect;
    out.timeline.loop = false;
    out.timeline.prewarm = false;
    return out;
}

/// Takes steps that somebody else chooses; 0: stays with its own.
void takeSteps(Timeline& timeline, int stepsPerSecond)
{
    if (stepsPerSecond > 0) {
        timeline.frameRate = stepsPerSecond;
        timeline.stepsPerFrame = 1;
    }
}

double secondsOfMachine()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

Result<LiveScene> LiveScene::start(const Scene& scene, const LiveOptions& options)
{
    if (Status status = checkOptions(options); !status) {
        return status.error();
    }
    for (std::size_t layer = 0; layer < scene.layers.size(); ++layer) {
        if (Status status = checkParent(scene, layer); !status) {
            return status.error();
        }
    }
    LiveScene out(scene, options);
    if (Status status = out.begin(); !status) {
        return status.error();
    }
    return out;
}

LiveScene::LiveScene(const Scene& scene, const LiveOptions& options)
    : m_scene(scene)
    , m_options(options)
    , m_visible(scene.visibleLayers())
{
    takeSteps(m_scene.timeline, options.stepsPerSecond);
    m_stepSeconds = 1.0 / (static_cast<double>(m_scene.timeline.frameRate) * m_scene.timeline.stepsPerFrame);
    if (options.budgetMs > 0.0) {
        constexpr double kSecondsPerMs = 1e-3;
        m_budget.emplace(options.budgetMs * kSecondsPerMs);
        if (!m_options.clock) {
            m_options.clock = secondsOfMachine;
        }
    }
    for (const Layer& layer : m_scene.layers) {
        m_layers.emplace_back(layer.emitter);
    }
}

Status LiveScene::begin()
{
    m_sampled.resize(m_visible.size());
    for (Layer& layer : m_scene.layers) {
        if (layer.tracks.find(knownParameter("emitter.rate")) != nullptr) {
            layer.emitter.rate = 1.0F; // room is made for as many as its key frames may let live
        }
    }
    sampleVisible();
    if (m_scene.air.enabled && !m_sampled.empty()) {
        if (Status status = checkAir(m_sampled); !status) {
            return status;
        }
        m_air = std::make_unique<LiveAir>(m_sampled);
    }
    setEffects();
    findOrder();
    if (Status status = makeRoom(); !status) {
        return status;
    }
    for (const std::size_t layer : m_visible) {
        m_frames.push_back({&m_layers[layer].frame(), &m_layers[layer].effect()});
    }
    if (hasTracks()) {
        animate();
        for (LiveLayer& layer : m_layers) {
            layer.placeAtTarget();
        }
    }
    return Done{};
}

void LiveScene::findOrder()
{
    std::vector<bool> isStepped(m_layers.size(), false);
    for (const std::size_t visible : m_visible) {
        std::vector<std::size_t> line; // it, and those that it is born on
        for (std::optional<std::size_t> layer = visible; layer && !isStepped[*layer];
             layer = parentOf(m_scene, *layer)) {
            line.push_back(*layer);
            isStepped[*layer] = true;
        }
        m_order.insert(m_order.end(), line.rbegin(), line.rend());
    }
    for (const std::size_t layer : m_order) {
        if (const std::optional<std::size_t> parent = parentOf(m_scene, layer)) {
            m_layers[layer].setParent(m_layers[*parent]);
        }
    }
}

Status LiveScene::makeRoom()
{
    const auto count = static_cast<std::int64_t>(m_order.size());
    std::int64_t wanted = 0;
    for (const std::size_t layer : m_order) {
        wanted += m_layers[layer].schedule().capacity();
    }
    std::int64_t most = m_options.mostParticles > 0 ? m_options.mostParticles : wanted;
    if (count > 1) {
        most = std::min<std::int64_t>(most, kMaxParticles);
    }
    if (most < count) {
        return Error{ErrorCode::OutOfRange, makeMessage("%1 particles are too few for %2 layers", most, count), {},
            makeMessage("Ask for %1 or more", count)};
    }
    for (const std::size_t layer : m_order) {
        const std::int64_t own = m_layers[layer].schedule().capacity();
        // Where they are too few each has one, and its share of the rest.
        m_layers[layer].makeRoom(most >= wanted ? most * own / wanted : 1 + (most - count) * own / wanted);
    }
    return Done{};
}

void LiveScene::sampleVisible()
{
    for (std::size_t i = 0; i < m_visible.size(); ++i) {
        m_sampled[i] = sampled(endless(simulatedEffect(m_scene, m_visible[i])));
    }
}

void LiveScene::setEffects()
{
    sampleVisible();
    std::uint32_t windSeed = m_scene.layers.front().emitter.seed;
    if (!m_visible.empty()) {
        findFeedingLayers(m_sampled, m_feeding);
        windSeed = m_sampled[m_feeding.front()]->emitter.seed;
    }
    const AirGrid* const grid = m_air ? &m_air->grid() : nullptr;
    auto visible = m_sampled.begin();
    for (std::size_t layer = 0; layer < m_layers.size(); ++layer) {
        m_layers[layer].setEffect(isVisible(layer) ? *visible++ : sampled(endless(simulatedEffect(m_scene, layer))),
            m_step + 1, windSeed, grid);
    }
    outdateLight();
}

Result<int> LiveScene::step(double seconds)
{
    if (!(seconds >= 0.0) || !std::isfinite(seconds)) {
        return Error{ErrorCode::OutOfRange, makeMessage("time that goes back, or is no number, is not possible"), {},
            makeMessage("Pass the seconds since the last step, 0 or more")};
    }
    // More than a year is let go in any case, and would end in infinities.
    constexpr double kLongest = 4e7; // s
    seconds = std::min(seconds, kLongest);
    // A game's 1/60 as a float is a hair away from a step: without this there would now and then be none, and two the
    // next time.
    constexpr double kRoundingOfFloats = 1e-6;
    const double before = m_saved;
    const double due = (before + seconds) / m_stepSeconds;
    const double whole = std::floor(due + kRoundingOfFloats);
    const int steps = static_cast<int>(std::min(whole, static_cast<double>(m_options.mostStepsAtOnce)));
    // time that is let go takes its part of the emitters' way with it
    const double stretch = steps > 0 ? whole / steps : 1.0;
    for (int i = 1; i <= steps; ++i) {
        const double share = seconds > 0.0 ? (i * stretch * m_stepSeconds - before) / seconds : 1.0;
        const bool isNow = share > 1.0 - kRoundingOfFloats;
        stepOnce(isNow ? 1.0 : std::max(0.0, share));
    }
    m_saved = (due - whole) * m_stepSeconds;
    for (LiveLayer& layer : m_layers) {
        layer.arrive();
    }
    if (m_air) {
        m_air->arrive();
    }
    return steps;
}

void LiveScene::stepOnce(double share)
{
    const auto now = [&] { return m_budget ? m_options.clock() : 0.0; };
    const double start = now();
    if (hasTracks()) {
        animate();
    }
    ++m_step;
    for (const std::size_t layer : m_order) {
        m_layers[layer].begin(m_step, share, keyedPose(layer));
    }
    stepAir(share);
    for (const std::size_t layer : m_order) {
        m_layers[layer].plan(m_air ? &m_air->field() : nullptr);
    }
    const double afterAir = now();
    std::int64_t full = 0;
    for (const std::size_t layer : m_order) {
        m_layers[layer].move(this->share(layer));
        full += m_layers[layer].effect()->emitter.count;
    }
    outdateLight();
    if (m_budget) {
        (void)m_budget->observe({afterAir - start, now() - afterAir}, living(), static_cast<std::size_t>(full));
    }
}

void LiveScene::stepAir(double share)
{
    if (!m_air) {
        return;
    }
    m_feeders.clear();
    for (const std::size_t feeding : m_feeding) {
        const std::size_t layer = m_visible[feeding];
        m_feeders.push_back(m_layers[layer].feeder(m_step, this->share(layer)));
    }
    const bool byKeys = obstacleGoesByKeys();
    m_air->step(m_feeders, m_step, byKeys ? 1.0 : share);
    if (byKeys) {
        m_air->arrive();
    }
}

void LiveScene::followEmitter(std::size_t layer, const Emitter& before, const Emitter& now)
{
    EmitterPose target = m_layers[layer].target();
    if (now.position != before.position) {
        target.position = now.position;
    }
    if (now.normal != before.normal) {
        target.normal = glm::normalize(now.normal);
    }
    m_layers[layer].setTarget(target);
}

Status LiveScene::setScene(const Scene& wanted)
{
    Scene scene = wanted;
    takeSteps(scene.timeline, m_options.stepsPerSecond);
    if (Status status = checkChange(m_scene, scene); !status) {
        return status;
    }
    for (std::size_t layer = 0; layer < m_layers.size(); ++layer) {
        followEmitter(layer, m_scene.layers[layer].emitter, scene.layers[layer].emitter);
    }
    m_scene = std::move(scene);
    setEffects();
    return Done{};
}

Status LiveScene::setEffect(std::size_t layer, const Effect& wanted)
{
    Effect effect = wanted;
    takeSteps(effect.timeline, m_options.stepsPerSecond);
    if (Status status = checkChange(m_scene.effect(layer), effect); !status) {
        return status;
    }
    followEmitter(layer, m_scene.layers[layer].emitter, effect.emitter);
    m_scene.assign(layer, effect);
    setEffects();
    return Done{};
}

Status LiveScene::setEmitter(std::size_t layer, const EmitterPose& pose)
{
    const Result<EmitterPose> target = checkedPose(pose);
    if (!target) {
        return target.error();
    }
    m_layers[layer].setTarget(target.value());
    return Done{};
}

Status LiveScene::placeEmitter(std::size_t layer, const EmitterPose& pose)
{
    if (Status status = setEmitter(layer, pose); !status) {
        return status;
    }
    m_layers[layer].placeAtTarget();
    return Done{};
}

Status LiveScene::setEmitters(const EmitterPose& pose)
{
    if (Status status = setEmitter(0, pose); !status) {
        return status;
    }
    const EmitterPose home = poseOf(m_scene.layers.front().emitter);
    for (std::size_t layer = 1; layer < m_layers.size(); ++layer) {
        m_layers[layer].setTarget(carriedAlong(poseOf(m_scene.layers[layer].emitter), home, m_layers[0].target()));
    }
    return Done{};
}

Status LiveScene::placeEmitters(const EmitterPose& pose)
{
    if (Status status = setEmitters(pose); !status) {
        return status;
    }
    for (LiveLayer& layer : m_layers) {
        layer.placeAtTarget();
    }
    return Done{};
}

void LiveScene::burst()
{
    for (LiveLayer& layer : m_layers) {
        layer.burst();
    }
}

float LiveScene::share(std::size_t layer) const
{
    return m_layers[layer].share(m_share, m_budget ? m_budget->share() : 1.0F);
}

std::size_t LiveScene::living() const
{
    std::size_t sum = 0;
    for (const std::size_t layer : m_order) {
        sum += m_layers[layer].living();
    }
    return sum;
}

void LiveScene::outdateLight()
{
    if (m_light) {
        m_light->outdate();
    }
}

LiveLight& LiveScene::light()
{
    if (!m_light) {
        m_light = std::make_unique<LiveLight>();
    }
    return *m_light;
}

Result<std::span<const glm::vec4>> LiveScene::litColours(std::size_t layer, const std::optional<glm::vec3>& eye)
{
    const auto place = std::find(m_visible.begin(), m_visible.end(), layer) - m_visible.begin();
    return isVisible(layer) ? light().colours(m_frames, static_cast<std::size_t>(place), eye)
                            : Result<std::span<const glm::vec4>>(std::span<const glm::vec4>());
}

Result<std::span<const glm::vec3>> LiveScene::normals(std::size_t layer)
{
    const auto place = std::find(m_visible.begin(), m_visible.end(), layer) - m_visible.begin();
    return isVisible(layer) ? light().normals(m_frames, static_cast<std::size_t>(place))
                            : Result<std::span<const glm::vec3>>(std::span<const glm::vec3>());
}

} // namespace fumage
