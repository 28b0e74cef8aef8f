#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

namespace fumage {

/// What parallelFor() calls: a function and what it belongs to.
struct ParallelBody {
    const void* object;
    void (*call)(const void* object, std::size_t index);
};
/// What parallelFor() is made of: use that.
void runParallel(std::size_t count, const ParallelBody& body);

/// Calls body(index) for every index in [0, count), on as many threads as the process allows.
/// The caller must make sure that bodies do not touch the same memory; results then never depend on the thread count.
/// An exception that leaves a body leaves the loop, once all bodies that had begun have ended.
template <class Body>
void parallelFor(std::size_t count, const Body& body)
{
    runParallel(
        count, {&body, [](const void* object, std::size_t index) { (*static_cast<const Body*>(object))(index); }});
}

/// How many bodies of one parallelFor() may run at the same time; 1 or more.
[[nodiscard]] std::size_t parallelThreads();

/// One T for each thread that asks for it: room to work in for bodies of parallelFor(). A body that itself runs a
/// parallelFor() must not hold on to its T meanwhile, since its thread may be lent to another body while it waits.
template <class T>
class PerThread {
public:
    /// The calling thread's T, made on its first call; stays where it is as long as this object lives. Thread-safe.
    [[nodiscard]] T& local()
    {
        const std::scoped_lock lock(m_mutex);
        std::unique_ptr<T>& mine = m_all[std::this_thread::get_id()];
        if (!mine) {
            mine = std::make_unique<T>();
        }
        return *mine;
    }

private:
    std::mutex m_mutex;
    std::map<std::thread::id, std::unique_ptr<T>> m_all;
};

/// From now on every thread that takes part in parallelFor() gives way to the other threads of the process and to other
/// programs, but for the process's first thread, which answers the user. For good: on Linux a thread may lower its
/// priority and not raise it again. Linux and Windows only.
void computeInBackground();

/// Runs work behind all else that the process computes: threads of its loops go to other loops first, as soon as there
/// are any, and the calling thread has the least priority from now on, for good (Linux and Windows only). Results are
/// the same.
void runBehindOthers(const std::function<void()>& work);

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
