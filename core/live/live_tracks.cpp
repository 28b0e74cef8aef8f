// What of a scene that a game plays changes over time by key frames.

#include "core/effect/known_parameter.h"
#include "core/effect/track_jumps.h"
#include "core/live/live_scene.h"

#include <algorithm>
#include <cmath>

namespace fumage {

bool LiveScene::hasTracks() const
{
    return !m_scene.tracks.empty() || std::any_of(m_scene.layers.begin(), m_scene.layers.end(), [](const Layer& layer) {
        return !layer.tracks.empty();
    });
}

LiveLayer::KeyedPose LiveScene::keyedPose(std::size_t layer) const
{
    static const Parameter& position = knownParameter("emitter.position");
    static const Parameter& normal = knownParameter("emitter.normal");
    const Tracks& tracks = m_scene.layers[layer].tracks;
    return {tracks.find(position) != nullptr, tracks.find(normal) != nullptr};
}

bool LiveScene::obstacleGoesByKeys() const
{
    static const Parameter& position = knownParameter("air.obstacle_position");
    static const Parameter& size = knownParameter("air.obstacle_size");
    return m_scene.tracks.find(position) != nullptr || m_scene.tracks.find(size) != nullptr;
}

void LiveScene::animate()
{
    double before = static_cast<double>(std::max<std::int64_t>(0, m_step)) * m_stepSeconds;
    double seconds = static_cast<double>(m_step + 1) * m_stepSeconds;
    const double end = m_stepSeconds * m_scene.timeline.stepsPerFrame * m_scene.timeline.length;
    if (m_scene.timeline.loop) {
        before = std::fmod(before, end);
        seconds = std::fmod(seconds, end);
    }
    Scene now = m_scene;
    for (std::size_t layer = 0; layer < m_layers.size(); ++layer) {
        now.assign(layer, m_scene.effectAt(layer, seconds));
        const Emitter& from = m_scene.layers[layer].emitter;
        const Emitter& to = now.layers[layer].emitter;
        followEmitter(layer, from, to);
        const auto jumps = [&](const Parameter& row) {
            const Track* track = m_scene.layers[layer].tracks.find(row);
            return track != nullptr && jumpsOnWay(*track, before, seconds, end);
        };
        if (to.position != from.position && jumps(knownParameter("emitter.position"))) {
            m_layers[layer].jumpToPosition();
        }
        if (to.normal != from.normal && jumps(knownParameter("emitter.normal"))) {
            m_layers[layer].jumpToNormal();
        }
    }
    m_scene = std::move(now);
    setEffects();
}

} // namespace fumage
