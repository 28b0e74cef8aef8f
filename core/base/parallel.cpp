#include "core/base/parallel.h"

#include <atomic>

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

namespace fumage {

namespace {

std::atomic<bool> s_background{false};

/// Once for each thread.
void giveWay()
{
#ifdef __linux__
    constexpr int kNice = 10;
    thread_local const bool s_gaveWay = gettid() == getpid() || setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice) == 0;
    (void)s_gaveWay;
#endif
}

} // namespace

void computeInBackground()
{
    s_background.store(true, std::memory_order_relaxed);
}

void runParallel(std::size_t count, const ParallelBody& body)
{
    if (count == 1) {
        body.call(body.object, 0);
        return;
    }
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1), [&](const tbb::blocked_range<std::size_t>& range) {
        if (s_background.load(std::memory_order_relaxed)) {
            giveWay();
        }
        for (std::size_t index = range.begin(); index != range.end(); ++index) {
            body.call(body.object, index);
        }
    });
}

struct ThreadLimit::Control {
    tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads)
    : m_control(new Control{
        tbb::global_control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads))})
{
}

ThreadLimit::~ThreadLimit() = default;

} // namespace fumage
