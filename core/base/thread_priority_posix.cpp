#include "core/base/thread_priority.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace fumage {

#ifdef __linux__

bool lowerPriority(ThreadPriority priority)
{
    const int nice = priority == ThreadPriority::Least ? 19 : 10;
    return setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), nice) == 0;
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
