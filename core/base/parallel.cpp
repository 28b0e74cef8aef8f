#include "core/base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

namespace fumage {

void runParallel(std::size_t count, const ParallelBody& body)
{
    if (count == 1) {
        body.call(body.object, 0);
        return;
    }
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1), [&](const tbb::blocked_range<std::size_t>& range) {
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
