#include "core/base/parallel.h"
#include "core/base/parallel_backend.h"

#include <algorithm>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace fumage {

void runParallel(std::size_t count, const ParallelBody& body)
{
    if (count == 1) {
        body.call(body.object, 0);
        return;
    }
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1), [&](const tbb::blocked_range<std::size_t>& range) {
        enterParallelLoop();
        for (std::size_t index = range.begin(); index != range.end(); ++index) {
            body.call(body.object, index);
        }
    });
}

void runInLowArena(const std::function<void()>& work)
{
    tbb::task_arena arena(tbb::task_arena::automatic, 1, tbb::task_arena::priority::low);
    arena.execute(work);
}

std::size_t parallelThreads()
{
    const auto arena = static_cast<std::size_t>(std::max(1, tbb::this_task_arena::max_concurrency()));
    return std::min(arena, tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
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
