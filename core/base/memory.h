#pragma once

#include "core/base/result.h"

#include <new>

namespace fumage {

/// Runs work whose size a user decides, and makes an error of memory that runs out: exceptions do not cross the border of a library or of a thread.
/// @param work returns a Result
/// @error OutOfMemory
template <class Work>
auto withinMemory(const Work& work) -> decltype(work())
{
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfMemory, said("there is not enough memory"), {}, said("Use a smaller picture or fewer particles")};
    }
}

} // namespace fumage
