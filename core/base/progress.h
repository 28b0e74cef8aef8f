#pragma once

#include <functional>
#include <type_traits>
#include <utility>

namespace fumage {

/// A part of long work.
enum class ProgressPhase {
    Air, ///< the steps of the air that carries the smoke
    PreRoll, ///< the steps that lead to a frame, where they are many
    Fitting, ///< looking at frames to place the camera
    Frames, ///< what was asked for
};

/// Hears how much of a part is done, on the thread that does it. May be empty.
class Progress {
public:
    Progress() = default;

    /// @param listener called with the part, how much of it is done, and how much it is in all
    template <class Listener>
    requires std::is_invocable_v<const Listener&, ProgressPhase, int, int> Progress(
        Listener listener) // NOLINT(google-explicit-constructor): functions are handed over as they are
        : m_listener(std::move(listener))
    {
    }

    /// @param listener called for frames that are looked at or done, and not for the steps that lead to them
    template <class Listener>
    requires std::is_invocable_v<const Listener&, int, int> Progress(
        Listener listener) // NOLINT(google-explicit-constructor): functions are handed over as they are
        : m_listener([listener = std::move(listener)](ProgressPhase work, int done, int total) {
            if (work == ProgressPhase::Fitting || work == ProgressPhase::Frames) {
                listener(done, total);
            }
        })
    {
    }

    void operator()(ProgressPhase work, int done, int total) const
    {
        if (m_listener) {
            m_listener(work, done, total);
        }
    }

private:
    std::function<void(ProgressPhase, int, int)> m_listener;
};

} // namespace fumage
