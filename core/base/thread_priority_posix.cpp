#include "core/base/thread_priority.h"

#ifdef __linux__
#include <algorithm>

#include <sys/resource.h>
#include <unistd.h>
#endif

namespace fumage {

#ifdef __linux__

bool lowerPriority(ThreadPriority priority)
{
    const auto thread = static_cast<id_t>(gettid());
    const int wanted = priority == ThreadPriority::Least ? 19 : 10;
    // Whoever was started with less already, by nice for instance, keeps that.
    return setpriority(PRIO_PROCESS, thread, std::max(wanted, getpriority(PRIO_PROCESS, thread))) == 0;
}

bool isFirstThread()
{
    return gettid() == getpid();
}

#else

// Elsewhere a priority belongs to the process.
bool lowerPriority(ThreadPriority /*priority*/)
{
    return false;
}

bool isFirstThread()
{
    return false;
}

#endif

} // namespace fumage
