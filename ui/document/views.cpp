#include "ui/document/views.h"

namespace fumage::ui {

namespace {

constexpr std::size_t kMaxViews = 100; ///< beyond them the oldest are forgotten

/// A camera that stands and looks as another does, and keeps its own lens and turntable.
Camera placedAs(const Camera& place, const Camera& camera)
{
    Camera placed = place;
    placed.turntable = camera.turntable;
    placed.focalLength = camera.focalLength;
    return placed;
}

} // namespace

void Views::reset(const Camera& camera)
{
    m_cameras = {camera};
    m_at = 0;
    m_gesture = 0;
}

void Views::move(const Camera& before, const Camera& after, quint64 gesture)
{
    m_cameras.resize(m_at + 1);
    const bool goesOn = gesture != 0 && gesture == m_gesture;
    if (!goesOn) {
        m_cameras.back() = before;
        m_cameras.push_back(after);
    }
    m_cameras.back() = after;
    m_gesture = gesture;
    if (m_cameras.size() > 1 && after == m_cameras[m_cameras.size() - 2]) { // back where the gesture began
        m_cameras.pop_back();
        m_gesture = 0;
    }
    if (m_cameras.size() > kMaxViews) {
        m_cameras.erase(m_cameras.begin());
    }
    m_at = m_cameras.size() - 1;
}

Camera Views::previous(const Camera& now)
{
    m_gesture = 0;
    m_cameras[m_at] = now;
    m_at -= hasPrevious() ? 1 : 0;
    return placedAs(m_cameras[m_at], now);
}

Camera Views::next(const Camera& now)
{
    m_gesture = 0;
    m_cameras[m_at] = now;
    m_at += hasNext() ? 1 : 0;
    return placedAs(m_cameras[m_at], now);
}

} // namespace fumage::ui
