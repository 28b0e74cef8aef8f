#include "core/base/parallel.h"

#include <tbb/global_control.h>

namespace fumage {

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
