#include "core/rendering/pass_renderer.h"

#include "core/base/parallel.h"
#include "core/lighting/glow.h"
#include "core/rendering/pass_kernel.h"
#include "core/rendering/sprite_kernel.h"

#include <algorithm>

#include <glm/vec2.hpp>

namespace fumage {

namespace {

/// White sun, and no other light but what the smoke gives of itself: the sprites have their own colour as that of the
/// sun, and their glow as all else.
Effect inWhiteSun(const Effect& effect)
{
    Effect white = effect;
    white.light.colour = glm::vec3(1.0F);
    white.light.ambient = 0.0F;
    return white;
}

/// From the heat from which smoke is seen to glow on, its share of the heat at birth. Cold smoke and soot have none.
Gradient heatOfWhatGlows(const Glow& glow)
{
    constexpr float kSeen = 1.0F / 255.0F; // of white, or of the brightest where that is less
    const GlowColours colours = glowColours(glow);
    const auto brightness = [&](std::size_t i) { return std::max({colours[i].r, colours[i].g, colours[i].b}); };
    float most = 0.0F;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        most = std::max(most, brightness(i));
    }
    if (!(glow.emission > 0.0F) || !(most > 0.0F)) {
        return {{0.0F, glm::vec3(0.0F)}, {1.0F, glm::vec3(0.0F)}};
    }
    std::size_t first = 0;
    while (glow.emission * brightness(first) < kSeen * std::min(1.0F, glow.emission * most)) {
        ++first;
    }
    const auto at = [](std::size_t i) { return static_cast<float>(i) / static_cast<float>(kGlowTableSize - 1); };
    if (first < 2) {
        return {{0.0F, glm::vec3(0.0F)}, {1.0F, glm::vec3(1.0F)}};
    }
    if (first + 1 == colours.size()) {
        return {{0.0F, glm::vec3(0.0F)}, {at(first - 1), glm::vec3(0.0F)}, {1.0F, glm::vec3(1.0F)}};
    }
    return {{0.0F, glm::vec3(0.0F)}, {at(first - 1), glm::vec3(0.0F)}, {at(first), glm::vec3(at(first))},
        {1.0F, glm::vec3(1.0F)}};
}

/// A glow that says how hot the smoke is.
Effect asThermometer(const Effect& effect)
{
    Effect thermometer = inWhiteSun(effect);
    thermometer.glow.emission = 1.0F;
    thermometer.glow.hotCore = effect.glow.emission > 0.0F ? effect.glow.hotCore : 0.0F;
    thermometer.glow.flameOpacity = 1.0F;
    thermometer.glow.fireLight = 0.0F;
    thermometer.glow.emissionColour = EmissionColour::Gradient;
    thermometer.glow.emissionGradient = heatOfWhatGlows(effect.glow);
    return thermometer;
}

/// Where particles of another turn of a loop are, each in the slot that it has in this one: in every turn slots are
/// counted on.
/// @param laps steps by which births are numbered higher there
/// @param room where they are put, if they lie elsewhere
const Particles* inTheSameSlots(const Frame& other, std::int64_t laps, Particles& room)
{
    const Schedule& schedule = other.model->schedule();
    const Particles& from = other.particles;
    const auto slots = static_cast<std::int64_t>(from.capacity);
    if (schedule.loopSteps == 0 || slots == 0) {
        return &from;
    }
    const std::int64_t births = laps / schedule.loopSteps * schedule.birthsPerPeriod;
    const std::int64_t shift = (births % slots + slots) % slots;
    if (shift == 0) {
        return &from;
    }
    room.reset(from.capacity);
    const auto turn = [&](const auto& column, auto& out) {
        std::rotate_copy(column.begin(), column.begin() + shift, column.begin() + slots, out.begin());
    };
    turn(from.x, room.x);
    turn(from.y, room.y);
    turn(from.z, room.z);
    turn(from.key, room.key);
    turn(from.birthStep, room.birthStep);
    return &room;
}

/// @param frames how many frames later it is shown, less than 0: earlier
/// @param room   where its particles are put, if they have other slots than now
OtherMoment momentOf(
    const Frame& now, const Frame* other, int frames, const Camera& camera, const glm::ivec2& size, Particles& room)
{
    OtherMoment moment;
    if (other == nullptr) {
        return moment;
    }
    // Where the loop starts again the numbers go back: the camera and the births are those of the turn that goes on.
    const Timeline& timeline = now.model->effect()->timeline;
    moment.view = makeView(camera, secondsOf(timeline, now.number + frames), size.x, size.y);
    moment.laps = static_cast<std::int32_t>(other->step - (now.step + frames * now.model->schedule().stepsPerFrame));
    moment.particles = inTheSameSlots(*other, moment.laps, room);
    return moment;
}

} // namespace

void PassRenderer::makeOtherSprites(
    const LayerAmongOthers& layer, const Effect& other, const LightGrid& light, std::size_t number)
{
    const LitLayer lit{layer.now, &other, &m_renderer.appearance(number), nullptr, layer.effect->tracks().get()};
    makeSprites(lit, light, m_renderer.surface(number), {}, m_renderer.batch(number).view, m_other);
}

void PassRenderer::take(const float (Sprite::*colour)[3], SpriteTarget& to)
{
    constexpr std::size_t kBlock = 4096;
    const std::size_t count = m_other.sprites.size();
    parallelFor((count + kBlock - 1) / kBlock, [&](std::size_t block) {
        for (std::size_t i = block * kBlock; i < std::min(count, (block + 1) * kBlock); ++i) {
            if (m_other.depth[i] != SpriteBatch::kHidden) {
                std::copy_n(m_other.sprites[i].*colour, 3,
                    to.colours.begin() + static_cast<std::ptrdiff_t>(i * SpriteTarget::kStride));
            }
        }
    });
}

void PassRenderer::makeSixWays(const FrameAmongOthers& frames)
{
    const View& view = m_renderer.batch().view;
    const Axes axes{view.right, view.up, view.forward};
    m_inView.resize(frames.layers.size());
    std::vector<LitLayer> lit;
    for (std::size_t i = 0; i < frames.layers.size(); ++i) {
        const LayerAmongOthers& layer = frames.layers[i];
        findAppearance(*layer.now, *layer.effect, axes, m_inView[i], m_renderer.texture(i)->greys(0));
        const Effect& effect = *layer.effect;
        lit.push_back({layer.now, &effect, &m_inView[i], m_renderer.detail(i)});
    }
    lightSixWays(lit, axes, view.eye, m_lightWorkspace, m_sixWay);
}

void PassRenderer::makeTargets(const FrameAmongOthers& frames, PassSet passes)
{
    for (std::vector<SpriteTarget>& of : m_targets) {
        of.resize(frames.layers.size());
    }
    if (needsTarget(passes, PassTarget::RightTopBack)) {
        makeSixWays(frames);
    }
    if (needsTarget(passes, PassTarget::Emission) || needsTarget(passes, PassTarget::Albedo)
        || needsTarget(passes, PassTarget::Inner)) {
        m_even = m_renderer.light();
        for (std::size_t i = 0; i < m_even.light.size(); i += SixWayLight::kStride) {
            m_even.light[i] = 1.0F;
        }
        m_even.diffuse.clear();
    }
    for (std::size_t i = 0; i < frames.layers.size(); ++i) {
        makeTargetsOf(frames, i, passes);
        fillColours(frames, i, passes);
    }
}

void PassRenderer::makeTargetsOf(const FrameAmongOthers& frames, std::size_t layer, PassSet passes)
{
    const LayerAmongOthers& of = frames.layers[layer];
    for (const PassTarget each : {PassTarget::RightTopBack, PassTarget::LeftBottomFront, PassTarget::Motion,
             PassTarget::Emission, PassTarget::Albedo, PassTarget::Inner}) {
        if (needsTarget(passes, each)) {
            target(each, layer).colours.resize(m_renderer.batch(layer).sprites.size() * SpriteTarget::kStride);
        }
    }
    target(PassTarget::RightTopBack, layer).light = TargetLight::RightTopBack;
    target(PassTarget::LeftBottomFront, layer).light = TargetLight::LeftBottomFront;
    target(PassTarget::Emission, layer).isTinted = true;
    target(PassTarget::Albedo, layer).isTinted = true;
    if (needsTarget(passes, PassTarget::Emission) || needsTarget(passes, PassTarget::Albedo)) {
        makeOtherSprites(of, inWhiteSun(*of.effect), m_even, layer);
        if (needsTarget(passes, PassTarget::Emission)) {
            take(&Sprite::ambient, target(PassTarget::Emission, layer));
        }
        if (needsTarget(passes, PassTarget::Albedo)) {
            take(&Sprite::direct, target(PassTarget::Albedo, layer));
        }
    }
    if (needsTarget(passes, PassTarget::Inner)) {
        makeOtherSprites(of, asThermometer(*of.effect), m_even, layer);
        take(&Sprite::ambient, target(PassTarget::Inner, layer));
    }
}

void PassRenderer::fillColours(const FrameAmongOthers& frames, std::size_t layer, PassSet passes)
{
    const LayerAmongOthers& of = frames.layers[layer];
    const SpriteBatch& batch = m_renderer.batch(layer);
    PassJob job;
    job.particles = &of.now->particles;
    job.batch = &batch;
    job.view = batch.view;
    if (needsTarget(passes, PassTarget::RightTopBack)) {
        job.sixWay = &m_sixWay;
        job.above = &target(PassTarget::RightTopBack, layer);
        job.below = &target(PassTarget::LeftBottomFront, layer);
    }
    if (needsTarget(passes, PassTarget::Motion)) {
        const glm::ivec2 size(batch.view.width, batch.view.height);
        const Effect& effect = *of.effect;
        job.previous = momentOf(*of.now, of.previous, -frames.sincePrevious, m_cameraBefore, size, m_previous);
        job.next = momentOf(*of.now, of.next, frames.untilNext, m_cameraAfter, size, m_next);
        job.seconds = static_cast<float>(frames.untilNext) / static_cast<float>(effect.timeline.frameRate)
            * effect.timeline.timeScale;
        job.motion = &target(PassTarget::Motion, layer);
    }
    if (needsTarget(passes, PassTarget::Inner)) {
        job.light = &m_renderer.light();
        job.inner = &target(PassTarget::Inner, layer);
    }
    parallelFor(
        batch.sprites.size() / kSpriteBlock, [&](std::size_t block) { makePassBlock(job, block * kSpriteBlock); });
}

const FrameAmongOthers& PassRenderer::atThatFrame(const FrameAmongOthers& frames)
{
    const LayerAmongOthers& first = frames.layers.front();
    const auto cameraOf = [&](const Frame* frame) {
        return frame == nullptr ? (*first.effect)->camera : first.effect->atFrame(frame->number)->camera;
    };
    m_cameraBefore = cameraOf(first.previous);
    m_cameraAfter = cameraOf(first.next);
    if (std::none_of(frames.layers.begin(), frames.layers.end(),
            [](const LayerAmongOthers& layer) { return layer.effect->tracks() != nullptr; })) {
        return frames;
    }
    m_now = frames;
    m_effects.clear();
    m_effects.reserve(frames.layers.size());
    for (LayerAmongOthers& layer : m_now.layers) {
        layer.effect = &m_effects.emplace_back(layer.effect->atFrame(layer.now->number));
    }
    return m_now;
}

Status PassRenderer::render(
    const FrameAmongOthers& all, int width, int height, PassSet passes, PassImages& images, const std::stop_token& stop)
{
    const FrameAmongOthers& frames = atThatFrame(all);
    const Effect& effect = *frames.layers.front().effect;
    const int factor = effect.output.supersample;
    const View view = makeView(
        effect.camera, secondsOf(effect.timeline, frames.layers.front().now->number), width * factor, height * factor);
    std::vector<LayerFrame> layers;
    for (const LayerAmongOthers& layer : frames.layers) {
        layers.push_back({layer.now, layer.effect});
    }
    if (Status status = m_renderer.prepare(layers, view, stop); !status) {
        return status;
    }
    makeTargets(frames, passes);
    m_passes = passes;
    m_factor = factor;
    return paint(0, layers.size(), images, stop);
}

/// Paints the targets of some layers, as many as there are from one on.
Status PassRenderer::paint(std::size_t first, std::size_t count, PassImages& images, const std::stop_token& stop)
{
    PassImages& painted = m_factor == 1 ? images : m_large;
    std::vector<RenderTarget> wanted;
    for (std::size_t i = 0; i < kPassTargets; ++i) {
        const auto which = static_cast<PassTarget>(i);
        if (needsTarget(m_passes, which)) {
            wanted.push_back(
                {which == PassTarget::Colour ? nullptr : m_targets[i].data() + first, &painted.targets[i]});
        } else {
            images.targets[i] = {};
        }
    }
    if (Status status = m_compositor.composeAll(m_renderer.layers().subspan(first, count), wanted, stop); !status) {
        return status;
    }
    for (std::size_t i = 0; m_factor > 1 && i < kPassTargets; ++i) {
        if (needsTarget(m_passes, static_cast<PassTarget>(i))) {
            images.targets[i] = downsample(m_large.targets[i], m_factor, stop);
        }
    }
    if (stop.stop_requested()) {
        return Error{ErrorCode::Cancelled, makeMessage("the picture was cancelled"), {}, {}};
    }
    return Done{};
}

} // namespace fumage
