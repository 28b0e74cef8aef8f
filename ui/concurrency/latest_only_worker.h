#pragma once

#include "ui/concurrency/guarded_thread.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>

namespace fumage::ui {

/// A thread that does the newest thing it was asked for and drops what was asked before; sleeps while there is nothing
/// to do.
template <class Request>
class LatestOnlyWorker {
public:
    /// Runs on the thread; should end early when stop is requested.
    using Work = std::function<void(const Request&, const std::stop_token&)>;
    /// Whether work on a request may be given up when a newer one comes.
    using MayStop = std::function<bool(const Request&)>;

    /// Work threw something: nothing comes of the request. On the thread, which goes on with the next.
    using Failed = std::function<void(const Request&, const Error&)>;

    LatestOnlyWorker(
        Work work, Failed failed, MayStop mayStop = [](const Request&) { return true; })
        : m_work(std::move(work))
        , m_failed(std::move(failed))
        , m_mayStop(std::move(mayStop))
        , m_thread([this](const std::stop_token& stop) { run(stop); }, [](const Error&) {})
    {
    }
    ~LatestOnlyWorker()
    {
        m_thread.requestStop();
        const std::lock_guard lock(m_mutex);
        m_running.request_stop();
    }
    LatestOnlyWorker(const LatestOnlyWorker&) = delete;
    LatestOnlyWorker& operator=(const LatestOnlyWorker&) = delete;

    void post(Request request)
    {
        const std::lock_guard lock(m_mutex);
        m_waiting = std::move(request);
        if (m_runningMayStop) {
            m_running.request_stop();
        }
        m_wake.notify_one();
    }

    /// Forgets what was asked for, and asks the work on what is being done to end, also where it may not be given up
    /// for something newer.
    void stop()
    {
        const std::lock_guard lock(m_mutex);
        m_waiting.reset();
        m_running.request_stop();
    }

private:
    struct Assignment {
        Request request;
        std::stop_token stop;
    };

    std::optional<Assignment> take(const std::stop_token& stop)
    {
        std::unique_lock lock(m_mutex);
        if (!m_wake.wait(lock, stop, [this] { return m_waiting.has_value(); }) || stop.stop_requested()) {
            return std::nullopt;
        }
        m_running = std::stop_source();
        m_runningMayStop = m_mayStop(*m_waiting);
        Assignment assignment{std::move(*m_waiting), m_running.get_token()};
        m_waiting.reset();
        return assignment;
    }

    void run(const std::stop_token& stop)
    {
        while (const std::optional<Assignment> assignment = take(stop)) {
            runGuarded([&] { m_work(assignment->request, assignment->stop); },
                [&](const Error& why) { m_failed(assignment->request, why); });
        }
    }

    Work m_work;
    Failed m_failed;
    MayStop m_mayStop;
    std::mutex m_mutex;
    std::condition_variable_any m_wake;
    std::optional<Request> m_waiting;
    std::stop_source m_running;
    bool m_runningMayStop = false;
    GuardedThread m_thread; ///< last: ends before what it uses
};

} // namespace fumage::ui
