#include "core/export/sheets/border_watch.h"

#include <algorithm>

namespace fumage {

namespace {

float maxBorderAlpha(const Image& cell)
{
    float most = 0.0F;
    for (int x = 0; x < cell.width; ++x) {
        most = std::max({most, cell.at(x, 0).a, cell.at(x, cell.height - 1).a});
    }
    for (int y = 0; y < cell.height; ++y) {
        most = std::max({most, cell.at(0, y).a, cell.at(cell.width - 1, y).a});
    }
    return most;
}

} // namespace

void BorderWatch::look(const Image& cell, const FrameAmongOthers& frames, const PassRenderer& renderer)
{
    if (m_scene.output.background != Background::Transparent) {
        return;
    }
    const Frame& frame = *frames.layers.front().now;
    for (std::size_t layer = 0; layer < frames.layers.size(); ++layer) {
        m_framing.addParticles(
            frames.layers[layer].now->particles, renderer.appearance(layer), secondsOf(m_scene.timeline, frame.number));
    }
    const float alpha = maxBorderAlpha(cell);
    m_alpha = std::max(m_alpha, alpha);
    constexpr float kSeen = 1.0F / 255.0F;
    if (alpha < kSeen) {
        return;
    }
    const PictureReach reach = reachOf(cell, kSeen);
    if (!m_cutOff) {
        m_cutOff = CutOff{.firstFrame = frame.number, .lastFrame = frame.number};
    }
    m_cutOff->firstFrame = std::min(m_cutOff->firstFrame, frame.number);
    m_cutOff->lastFrame = std::max(m_cutOff->lastFrame, frame.number);
    m_cutOff->left |= reach.left == 0;
    m_cutOff->top |= reach.top == 0;
    m_cutOff->right |= reach.right == cell.width;
    m_cutOff->bottom |= reach.bottom == cell.height;
}

void BorderWatch::report(Flipbook& flipbook) const
{
    flipbook.edgeAlpha = m_alpha;
    flipbook.cutOff = m_cutOff;
    if (m_cutOff && m_scene.camera.mode == CameraMode::Orbit) {
        flipbook.cutOff->distance = m_framing.distanceFrom(m_scene.camera.target);
    }
}

} // namespace fumage
