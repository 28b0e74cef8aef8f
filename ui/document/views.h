#pragma once

#include "core/effect/effect.h"

#include <QtGlobal>

#include <vector>

namespace fumage::ui {

/// The ways of looking at one document, in the order in which they were taken: what a browser has of pages.
class Views {
public:
    /// Begins anew.
    void reset(const Camera& camera);

    /// The camera has been moved by hand.
    /// @param before    where it was: somebody else may have moved it since the last view
    /// @param gesture   moves of one gesture are one view; 0: a view of its own
    void move(const Camera& before, const Camera& after, quint64 gesture);

    [[nodiscard]] bool hasPrevious() const { return m_at > 0; }
    [[nodiscard]] bool hasNext() const { return m_at + 1 < m_cameras.size(); }
    /// @param now   what is no matter of where one looks from stays as it is in this
    /// @return the camera of the view before or after this one; that one is the present view from now on
    [[nodiscard]] Camera previous(const Camera& now);
    [[nodiscard]] Camera next(const Camera& now);

private:
    std::vector<Camera> m_cameras{Camera()};
    std::size_t m_at = 0;
    quint64 m_gesture = 0; ///< that made the present view
};

} // namespace fumage::ui
