#include "core/effect/sampling.h"

#include "core/effect/known_parameter.h"
#include "core/effect/value.h"

#include <algorithm>
#include <cmath>

namespace fumage {

namespace {

constexpr const Parameter& kSize = knownParameter("look.size");
constexpr const Parameter& kOpacity = knownParameter("look.opacity");
constexpr const Parameter& kTurntable = knownParameter("camera.turntable");

/// Angle by which a camera has turned since frame 0, degrees: the sum of its speed in the middle of each frame.
double turnedBy(const Track& turntable, int number, int frameRate)
{
    double sum = 0.0;
    for (int frame = 0; frame < number; ++frame) {
        sum += static_cast<double>(std::get<float>(turntable.at((frame + 0.5) / frameRate)));
    }
    return sum / frameRate;
}

/// Whether a parameter is summed up over each particle's life when it is drawn.
bool isOwnRate(const Parameter& row)
{
    return row.animates == Animates::Rate && row.scope == Scope::Layer && row.dirties == DirtyStage::Shade;
}

} // namespace

double secondsOfFrame(const Timeline& timeline, int number)
{
    return static_cast<double>(timeline.loop ? number % timeline.length : number) / timeline.frameRate;
}

double lengthInSeconds(const Timeline& timeline)
{
    return static_cast<double>(timeline.length) / timeline.frameRate;
}

void SampledEffect::scaleLook(float size, float opacity)
{
    if (size != 1.0F) {
        setClamped(m_effect, kSize, m_effect.look.size * size);
    }
    if (opacity != 1.0F) {
        setClamped(m_effect, kOpacity, m_effect.look.opacity * opacity);
    }
}

void readFrame(const Tracks& tracks, int number, Effect& effect)
{
    const Timeline& timeline = effect.timeline;
    tracks.read(Animates::Frame, secondsOfFrame(timeline, number), effect);
    if (const Track* turntable = tracks.find(kTurntable)) {
        constexpr double kFullTurn = 360.0;
        const double turned =
            turnedBy(*turntable, timeline.loop ? number % timeline.length : number, timeline.frameRate);
        effect.camera.yaw += static_cast<float>(std::fmod(turned, kFullTurn));
        effect.camera.turntable = 0.0F;
    }
}

SampledEffect SampledEffect::atFrame(int number) const
{
    SampledEffect out = *this;
    if (m_tracks) {
        readFrame(*m_tracks, number, out.m_effect);
        out.scaleLook(changes(kSize) ? m_sizeFactor : 1.0F, changes(kOpacity) ? m_opacityFactor : 1.0F);
        out.m_tracks = m_ownRates;
    }
    return out;
}

SampledEffect SampledEffect::atTime(double seconds) const
{
    SampledEffect out = *this;
    if (m_tracks) {
        for (const Animates when : {Animates::Step, Animates::Birth, Animates::Rate}) {
            m_tracks->read(when, seconds, out.m_effect);
        }
        out.m_tracks = out.m_ownRates = nullptr;
    }
    return out;
}

SampledEffect SampledEffect::strongest() const
{
    SampledEffect out = *this;
    out.m_tracks = out.m_ownRates = nullptr;
    for (const Track& track : m_tracks ? m_tracks->all() : std::span<const Track>()) {
        if (track.parameter->kind == Kind::Float) {
            const auto size = [](const KeyFrame& key) { return std::abs(std::get<float>(key.value)); };
            const auto greatest = std::max_element(track.keys.begin(), track.keys.end(),
                [&](const KeyFrame& one, const KeyFrame& other) { return size(one) < size(other); });
            track.parameter->set(out.m_effect, greatest->value);
        }
    }
    return out;
}

SampledEffect sampled(const Effect& effect, const Tracks& tracks)
{
    SampledEffect out(effect);
    Effect& own = out.m_effect;
    Tracks changing;
    Tracks ownRates;
    for (const Track& track : tracks.all()) {
        if (track.isConstant()) {
            track.parameter->set(own, track.keys.front().value);
            continue;
        }
        changing.set(track);
        if (isOwnRate(*track.parameter)) {
            ownRates.set(track);
        }
    }
    if (!changing.empty()) {
        out.m_tracks = std::make_shared<const Tracks>(std::move(changing));
    }
    if (!ownRates.empty()) {
        out.m_ownRates = std::make_shared<const Tracks>(std::move(ownRates));
    }
    own.output.quality = Quality::Good;
    if (effect.output.quality == Quality::Good) {
        return out;
    }
    const bool fine = effect.output.quality == Quality::Final;
    constexpr int kFiner = 8;
    constexpr int kCoarser = 4;
    const int count = effect.emitter.count;
    own.emitter.count =
        fine ? (count > kMaxParticles / kFiner ? kMaxParticles : count * kFiner) : std::max(1, count / kCoarser);
    // What makes smoke dense is count * size^2 * opacity.
    const float ratio = static_cast<float>(count) / static_cast<float>(own.emitter.count);
    const float root = std::sqrt(ratio);
    out.m_sizeFactor = std::sqrt(root);
    out.m_opacityFactor = root;
    out.scaleLook(out.m_sizeFactor, out.m_opacityFactor);
    return out;
}

SampledEffect thinned(const SampledEffect& effect, int most)
{
    SampledEffect fewer = effect;
    Effect& out = fewer.m_effect;
    if (out.emitter.count > most) {
        // What covers the picture is count * size^2.
        const float ratio = static_cast<float>(out.emitter.count) / static_cast<float>(most);
        out.emitter.count = most;
        fewer.m_sizeFactor *= std::sqrt(ratio);
        fewer.scaleLook(std::sqrt(ratio), 1.0F);
    }
    return fewer;
}

} // namespace fumage
