#pragma once

#include <cstddef>
#include <memory>

namespace fumage {

/// What parallelFor() calls: a function and what it belongs to.
struct ParallelBody {
    const void* object;
    void (*call)(const void* object, std::size_t index);
};
void runParallel(std::size_t count, const ParallelBody& body);

/// Calls body(index) for every index in [0, count), on as many threads as the process allows.
/// The caller must make sure that bodies do not touch the same memory; results then never depend on the thread count.
template <class Body>
void parallelFor(std::size_t count, const Body& body)
{
    runParallel(count, {&body, [](const void* object, std::size_t index) { (*static_cast<const Body*>(object))(index); }});
}

/// From now on every thread that takes part in parallelFor() gives way to the other threads of the process and to other programs, but for the
/// process's first thread, which answers the user. For good: a thread may lower its priority and not raise it again. Linux only.
void computeInBackground();

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
