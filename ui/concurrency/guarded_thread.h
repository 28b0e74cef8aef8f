#pragma once

#include "core/base/caught.h"

#include <functional>
#include <stop_token>
#include <thread>

namespace fumage::ui {

/// Does work, and tells what it throws: an exception that left a thread would end the program, with all documents that
/// are open.
/// @param failed gets the Error
template <class Work, class Failed>
void runGuarded(const Work& work, const Failed& failed) noexcept
{
    try {
        work();
    } catch (...) {
        try {
            failed(caughtError());
        } catch (
            ...) { // NOLINT(bugprone-empty-catch): there is not even the memory to say so; what is lost is a message
        }
    }
}

/// A thread that cannot end the program. All threads of the editor are of this kind.
class GuardedThread {
public:
    /// Should end early when stop is requested.
    using Work = std::function<void(const std::stop_token&)>;
    /// On the thread.
    using Failed = std::function<void(const Error&)>;

    GuardedThread() = default;
    /// @throws std::system_error where no thread can be had
    GuardedThread(Work work, Failed failed)
        : m_thread([work = std::move(work), failed = std::move(failed)](
                       const std::stop_token& stop) { runGuarded([&] { work(stop); }, failed); })
    {
    }

    void requestStop() { m_thread.request_stop(); }

private:
    std::jthread m_thread;
};

} // namespace fumage::ui
