#pragma once

#include "core/lighting/light_grid.h"

namespace fumage {

/// Weights every cell's density and that of its neighbours by 1/4, 1/2, 1/4 along each axis; there is none outside the
/// grid.
/// @param density a float a cell, and room for a vector to be read past them
/// @param plane   along w
/// @param around  a float a cell
void findDensityAround(const GridShape& shape, const float* density, int plane, float* around);

/// Grows the particles of a chunk that fewer overlap than asked.
/// @param around  by findDensityAround()
/// @param overlap more than 1
void growChunk(const Particles& particles, const GridShape& shape, const float* around, float overlap,
    std::size_t chunk, Appearance& appearance);

} // namespace fumage
