#pragma once

#include "core/noise/fractal.h"
#include "core/noise/row_positions.h"

#include <memory>

namespace fumage {

/// One octave of a slice with everything that does not change from row to row.
struct OctaveSlice {
    const Noise& noise;
    Octave octave;
    int size = 0; ///< pixels
    float cellsAPixel = 1.0F;
    float z = 0.0F; ///< in lattice units
    RowPositions positions; ///< in cells between lattice points
    RowPositions around; ///< in cells around lattice points; for simplex noise only
};

/// @param noise outlives the slice
/// @param depth in [0, 1)
[[nodiscard]] OctaveSlice octaveSlice(const Noise& noise, const Octave& octave, int size, float depth);

/// Adds the rows of one octave to rows of pixels, and keeps the rows of lattice points that the next row of pixels
/// needs again. For one thread; any order of rows gives the same values, but an ascending one is fast.
class OctaveRows {
public:
    /// @param slice outlives the rows
    [[nodiscard]] static std::unique_ptr<OctaveRows> of(const OctaveSlice& slice);

    OctaveRows(const OctaveRows&) = delete;
    OctaveRows& operator=(const OctaveRows&) = delete;
    virtual ~OctaveRows() = default;

    /// @param row    row of pixels
    /// @param values at a multiple of kAlignment, size rounded up to whole blocks of RowPositions::kBlock
    virtual void add(int row, float* values) = 0;

protected:
    OctaveRows() = default;
};

} // namespace fumage
