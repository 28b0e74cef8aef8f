#pragma once

#include "core/base/parallel.h"
#include "core/flow/grid.h"

namespace fumage {

/// A grid with fewer places, ghosts among them, is done by one thread: to share it would take longer.
inline constexpr std::size_t kWorthSharing = 24576;

/// Calls body(i) for first, first + stride and so on below last, in any order.
/// @param places of the grid that they are of: few are done by one thread
template <class Body>
void forPlanes(std::size_t places, int first, int last, int stride, const Body& body)
{
    if (places < kWorthSharing) {
        for (int i = first; i < last; i += stride) {
            body(i);
        }
        return;
    }
    parallelFor(static_cast<std::size_t>((last - first + stride - 1) / stride),
        [&](std::size_t i) { body(first + stride * static_cast<int>(i)); });
}

/// The same, on all threads where the grid is worth it.
template <class Body>
void forPlanes(const ColumnLayout& layout, int first, int last, int stride, const Body& body)
{
    forPlanes(layout.size, first, last, stride, body);
}

/// Calls body(k) for all planes of a box, in any order, on all threads where it is worth it.
template <class Body>
void forPlanes(const CellBox& box, const Body& body)
{
    const glm::ivec3 n = box.high - box.low;
    forPlanes(static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y) * static_cast<std::size_t>(n.z), box.low.z,
        box.high.z, 1, body);
}

/// Calls visit(place of the first, number of them) for the rows of a box, likewise.
template <class Visit>
void forRows(const ColumnLayout& layout, const CellBox& box, const Visit& visit)
{
    forPlanes(box, [&](int k) {
        for (int j = box.low.y; j < box.high.y; ++j) {
            visit(layout.at(box.low.x, j, k), box.high.x - box.low.x);
        }
    });
}

} // namespace fumage
