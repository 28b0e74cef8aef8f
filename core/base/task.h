#pragma once

#include "core/base/progress.h"

#include <concepts>
#include <stop_token>
#include <utility>

namespace fumage {

/// What goes along with long work: who hears how far it is, and who may stop it; without more, nobody. It is handed
/// over last, and by reference for the length of a call: who keeps it longer copies it.
struct Task {
    Task() = default;

    /// @param listener a Progress, or a function that makes one
    /// @param asked    whether the work is to stop; by default it never is
    template <std::convertible_to<Progress> Listener>
    Task(Listener listener, std::stop_token asked = {}) // NOLINT(google-explicit-constructor): as Progress is made
        : progress(std::move(listener))
        , stop(std::move(asked))
    {
    }

    /// Of work that nobody hears of.
    Task(std::stop_token asked) // NOLINT(google-explicit-constructor): tokens are handed over as they are
        : stop(std::move(asked))
    {
    }

    /// Whether the work is to stop. From any thread.
    [[nodiscard]] bool stopped() const { return stop.stop_requested(); }

    Progress progress; ///< heard on the thread that does the work
    std::stop_token stop;
};

} // namespace fumage
