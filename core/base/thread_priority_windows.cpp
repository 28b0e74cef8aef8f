#include "core/base/thread_priority.h"

#include "core/base/windows_api.h"

namespace fumage {

namespace {

const DWORD s_first = ::GetCurrentThreadId(); ///< what is outside functions, the first thread makes

} // namespace

bool lowerPriority(ThreadPriority priority)
{
    return ::SetThreadPriority(::GetCurrentThread(),
               priority == ThreadPriority::Least ? THREAD_PRIORITY_LOWEST : THREAD_PRIORITY_BELOW_NORMAL)
        != 0;
}

bool isFirstThread()
{
    return ::GetCurrentThreadId() == s_first;
}

} // namespace fumage
