#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <stdexcept>
#include <vector>

#include <QtTest/QtTest>

#include <sys/resource.h>
#include <unistd.h>

using namespace fumage;

class ParallelTest : public QObject {
    Q_OBJECT

private slots:
    void everyIndexIsRunOnce()
    {
        for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
            std::vector<std::atomic<int>> runs(count);
            parallelFor(count, [&](std::size_t index) { ++runs[index]; });
            QVERIFY(std::all_of(runs.begin(), runs.end(), [](const std::atomic<int>& each) { return each == 1; }));
        }
    }

    void aLoopInsideALoopRunsEveryIndexOnce()
    {
        constexpr std::size_t kEdge = 40;
        std::vector<std::atomic<int>> runs(kEdge * kEdge);
        parallelFor(kEdge, [&](std::size_t y) { parallelFor(kEdge, [&](std::size_t x) { ++runs[y * kEdge + x]; }); });
        QVERIFY(std::all_of(runs.begin(), runs.end(), [](const std::atomic<int>& each) { return each == 1; }));
    }

    void loopsOfSeveralThreadsDoNotMix()
    {
        std::atomic<int> sum{0};
        std::vector<std::jthread> threads;
        for (int i = 0; i < 4; ++i) {
            threads.emplace_back([&] { parallelFor(100, [&](std::size_t) { ++sum; }); });
        }
        threads.clear();
        QCOMPARE(sum.load(), 400);
    }

    void workBehindOthersIsDoneAndItsThreadGivesWay()
    {
        std::vector<std::atomic<int>> runs(1000);
        int nice = 0;
        bool caught = false;
        std::jthread thread([&] {
            try {
                runBehindOthers([&] {
                    nice = getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
                    parallelFor(runs.size(), [&](std::size_t index) { ++runs[index]; });
                    throw std::runtime_error("as any other");
                });
            } catch (const std::runtime_error&) {
                caught = true;
            }
        });
        thread.join();
        QVERIFY(std::all_of(runs.begin(), runs.end(), [](const std::atomic<int>& each) { return each == 1; }));
        QVERIFY(caught);
        QCOMPARE(nice, 19);
    }

    void anExceptionLeavesTheLoop()
    {
        std::atomic<int> running{0};
        const auto loop = [&] {
            parallelFor(1000, [&](std::size_t index) {
                ++running;
                if (index == 500) {
                    --running;
                    throw std::runtime_error("no memory");
                }
                --running;
            });
        };
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, loop());
        QCOMPARE(running.load(), 0);
        std::atomic<int> after{0};
        parallelFor(100, [&](std::size_t) { ++after; });
        QCOMPARE(after.load(), 100);
    }

    void aLimitOfOneKeepsToTheCallingThread()
    {
        const auto elsewhere = [] {
            std::atomic<int> count{0};
            const auto caller = std::this_thread::get_id();
            parallelFor(1000, [&](std::size_t) { count += std::this_thread::get_id() == caller ? 0 : 1; });
            return count.load();
        };
        const std::size_t before = parallelThreads();
        {
            const ThreadLimit limit(1);
            QCOMPARE(parallelThreads(), std::size_t{1});
            QCOMPARE(elsewhere(), 0);
        }
        QCOMPARE(parallelThreads(), before);
    }

    void moreThreadsThanOneTakePart()
    {
        if (parallelThreads() == 1) {
            return; // a machine of one core
        }
        // Each of two bodies waits for the other: one thread alone would never end.
        std::mutex mutex;
        std::condition_variable bothThere;
        int there = 0;
        parallelFor(2, [&](std::size_t) {
            std::unique_lock lock(mutex);
            ++there;
            bothThere.notify_all();
            bothThere.wait(lock, [&] { return there == 2; });
        });
        QCOMPARE(there, 2);
    }

    void everyThreadHasItsOwn()
    {
        PerThread<int> own;
        int* const mine = &own.local();
        QCOMPARE(*mine, 0);
        std::thread([&] { QVERIFY(&own.local() != mine); }).join();
        QVERIFY(&own.local() == mine);
        // Nobody else counts here at the same time: the sum is exact without an atomic.
        PerThread<std::vector<std::size_t>> seen;
        std::vector<std::atomic<int>> runs(1000);
        parallelFor(runs.size(), [&](std::size_t index) {
            seen.local().push_back(index);
            ++runs[seen.local().back()];
        });
        QVERIFY(std::all_of(runs.begin(), runs.end(), [](const std::atomic<int>& each) { return each == 1; }));
    }

    void computingGivesWayToTheFirstThread()
    {
        const auto lowestPriority = [] {
            std::atomic<int> nice{-100};
            std::thread([&] {
                parallelFor(1000, [&](std::size_t) {
                    int seen = nice.load();
                    const int mine = getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
                    while (mine > seen && !nice.compare_exchange_weak(seen, mine)) { }
                });
            }).join();
            return nice.load();
        };
        const int before = getpriority(PRIO_PROCESS, 0);
        QCOMPARE(lowestPriority(), before);
        computeInBackground();
        const int behind = lowestPriority();
        QVERIFY(behind > before || (behind == before && before >= 10)); // there already, when the tests run under nice
        std::thread([] {
            setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), 15);
            parallelFor(1000, [](std::size_t) {});
            QVERIFY(getpriority(PRIO_PROCESS, static_cast<id_t>(gettid())) >= 15);
        }).join();
        parallelFor(1000, [](std::size_t) {});
        QCOMPARE(getpriority(PRIO_PROCESS, 0), before);
    }
};

QTEST_GUILESS_MAIN(ParallelTest)
#include "parallel_test.moc"
