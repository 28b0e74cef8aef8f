// Parallel loops with nothing but the standard library: for ThreadSanitizer, which follows every lock and atomic here
// and none inside a TBB that was not built for it, and for platforms without TBB. Threads are made anew for each loop,
// which costs some 20 us each.

#include "core/base/parallel.h"
#include "core/base/parallel_backend.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <stop_token>
#include <system_error>
#include <thread>
#include <vector>

namespace fumage {

namespace {

/// 0: as many as the machine has.
std::atomic<std::size_t> s_limit{0};

/// A loop inside a loop is run by the thread that meets it: the outer one keeps all of them busy.
thread_local bool s_insideLoop = false;

/// One loop, as its threads share it.
class Loop {
public:
    Loop(std::size_t count, const ParallelBody& body)
        : m_count(count)
        , m_body(body)
    {
    }

    void work()
    {
        s_insideLoop = true;
        enterParallelLoop();
        try {
            for (std::size_t index = m_next.fetch_add(1); index < m_count; index = m_next.fetch_add(1)) {
                m_body.call(m_body.object, index);
            }
        } catch (...) {
            m_next.store(m_count);
            const std::scoped_lock lock(m_mutex);
            m_error = std::current_exception();
        }
        s_insideLoop = false;
    }

    void rethrow() const
    {
        if (m_error) {
            std::rethrow_exception(m_error);
        }
    }

private:
    const std::size_t m_count;
    const ParallelBody m_body;
    std::atomic<std::size_t> m_next{0};
    std::mutex m_mutex;
    std::exception_ptr m_error;
};

} // namespace

void runParallel(std::size_t count, const ParallelBody& body)
{
    const std::size_t threads = s_insideLoop ? 1 : std::min(count, parallelThreads());
    if (threads <= 1) {
        for (std::size_t index = 0; index < count; ++index) {
            body.call(body.object, index);
        }
        return;
    }
    Loop loop(count, body);
    {
        std::vector<std::jthread> helpers;
        helpers.reserve(threads - 1);
        try {
            for (std::size_t i = 1; i < threads; ++i) {
                helpers.emplace_back([&loop] { loop.work(); });
            }
        } catch (const std::system_error&) {
            // The system has no more threads: those that came do all of the work.
        }
        loop.work();
    }
    loop.rethrow();
}

void runInLowArena(const std::function<void()>& work)
{
    work();
}

std::size_t parallelThreads()
{
    const std::size_t limit = s_limit.load();
    return limit > 0 ? limit : std::max<std::size_t>(1, std::thread::hardware_concurrency());
}

struct ThreadLimit::Control {
    std::size_t before;
};

ThreadLimit::ThreadLimit(int threads)
    : m_control(new Control{s_limit.load()})
{
    const auto mine = static_cast<std::size_t>(threads);
    s_limit.store(m_control->before > 0 ? std::min(m_control->before, mine) : mine);
}

ThreadLimit::~ThreadLimit()
{
    s_limit.store(m_control->before);
}

} // namespace fumage
