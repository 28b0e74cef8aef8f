#pragma once

#include <functional>

namespace fumage {

/// What every thread calls before it takes part in a parallel loop: gives way where computeInBackground() asked for it.
/// The loops themselves, parallelThreads() and ThreadLimit are in parallel_tbb.cpp or, where the build says so, in
/// parallel_threads.cpp.
void enterParallelLoop();

/// What runBehindOthers() is made of: the work, whose loops give way to others where the backend can tell them apart.
void runInLowArena(const std::function<void()>& work);

} // namespace fumage
