#pragma once

#include <cstddef>
#include <memory>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace fumage {

/// Calls body(index) for every index in [0, count), on as many threads as the process allows.
/// The caller must make sure that bodies do not touch the same memory; results then never depend on the thread count.
template <class Body>
void parallelFor(std::size_t count, const Body& body)
{
    if (count <= 1) {
        if (count == 1) {
            body(std::size_t{0});
        }
        return;
    }
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1), [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t index = range.begin(); index != range.end(); ++index) {
            body(index);
        }
    });
}

/// While alive, the process uses at most this many threads for parallelFor.
class ThreadLimit {
public:
    /// @param threads 1 or more
    explicit ThreadLimit(int threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    struct Control;
    std::unique_ptr<Control> m_control;
};

} // namespace fumage
