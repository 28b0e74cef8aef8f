#include "core/base/parallel.h"

#include "core/base/parallel_backend.h"

#include <atomic>

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

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

void enterParallelLoop()
{
    if (s_background.load(std::memory_order_relaxed)) {
        giveWay();
    }
}

void runBehindOthers(const std::function<void()>& work)
{
#ifdef __linux__
    constexpr int kLeast = 19;
    (void)setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kLeast);
#endif
    runInLowArena(work);
}

} // namespace fumage
