#pragma once

#include "core/base/caught.h"

namespace fumage {

/// Runs work whose size a user decides, and makes an error of memory that runs out, and of all else that is thrown:
/// exceptions do not cross the border of a library or of a thread.
/// @param work returns a Result
/// @error those of caughtError()
template <class ProgressPhase>
auto withinMemory(const ProgressPhase& work) -> decltype(work())
{
    try {
        return work();
    } catch (...) {
        return caughtError();
    }
}

} // namespace fumage
