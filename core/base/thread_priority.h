#pragma once

namespace fumage {

/// How far a thread lets others go first.
enum class ThreadPriority {
    BehindWindow, ///< behind what answers the user
    Least, ///< behind everything
};

/// Lowers the priority of the calling thread; on Linux for good. @return whether the system has done it
bool lowerPriority(ThreadPriority priority);

/// Whether the calling thread is the one that the process began with.
[[nodiscard]] bool isFirstThread();

} // namespace fumage
