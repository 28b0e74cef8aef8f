#include "core/base/parallel.h"

#include "core/base/parallel_backend.h"
#include "core/base/thread_priority.h"

#include <atomic>

namespace fumage {

namespace {

std::atomic<bool> s_background{false};

/// Once for each thread.
void yieldToOthers()
{
    thread_local const bool s_gaveWay = isFirstThread() || lowerPriority(ThreadPriority::BehindWindow);
    (void)s_gaveWay;
}

} // namespace

void computeInBackground()
{
    s_background.store(true, std::memory_order_relaxed);
}

void enterParallelLoop()
{
    if (s_background.load(std::memory_order_relaxed)) {
        yieldToOthers();
    }
}

void runBehindOthers(const std::function<void()>& work)
{
    (void)lowerPriority(ThreadPriority::Least);
    runInLowArena(work);
}

} // namespace fumage
