#pragma once

#include "core/base/parallel.h"
#include "core/flow/grid.h"

namespace fumage {

/// A grid with fewer places, ghosts among them, is done by one thread: to share it would take longer.
inline constexpr std::size_t kWorthSharing = 24576;

/// Calls body(i) for first, first + stride and so on below last, in any order, on all threads where the grid is worth
/// it.
template <class Body>
void forPlanes(const ColumnLayout& layout, int first, int last, int stride, const Body& body)
{
    if (layout.size < kWorthSharing) {
        for (int i = first; i < last; i += stride) {
            body(i);
        }
        return;
    }
    parallelFor(static_cast<std::size_t>((last - first + stride - 1) / stride),
        [&](std::size_t i) { body(first + stride * static_cast<int>(i)); });
}

} // namespace fumage
