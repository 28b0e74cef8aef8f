#pragma once

#include "core/base/parallel.h"

#include <cstddef>

namespace fumage {

/// Calls body(w) for each plane of a grid: on several threads where that is worth it.
/// @param planes how many @param cells of all planes
template <class Body>
void forGridPlanes(int planes, std::size_t cells, const Body& body)
{
    constexpr std::size_t kWorthThreads = 16384; // cells
    if (cells >= kWorthThreads) {
        parallelFor(static_cast<std::size_t>(planes), [&](std::size_t w) { body(static_cast<int>(w)); });
        return;
    }
    for (int w = 0; w < planes; ++w) {
        body(w);
    }
}

} // namespace fumage
