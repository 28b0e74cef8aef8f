#pragma once

#include "core/base/float4.h"
#include "core/lighting/light_field.h"

namespace fumage {

struct Light;

/// Lets what each cell takes of a light wander from cell to cell until it leaves: the diffusion approximation of
/// radiative transfer, div(grad(phi) / 3 s) = a s phi - taken, with s the extinction and a = 0.005 the share that each
/// scattering absorbs (Stam, "Multiple scattering as a diffusion process", 1995; Ishimaru, "Wave Propagation and
/// Scattering in Random Media", 1978). Outside of the grid it is dark; light crosses clear air as if that scattered it
/// some times on the way through the whole grid. Solved from the coarsest of ever larger cells to the finest, each from
/// what the one before has found (cascadic multigrid: Bornemann and Deuflhard 1996).
/// @param density    extinction, 1/m, of each cell
/// @param extinction factor on it, for each of four lights
/// @param light      four floats a cell: what it takes of each light, 1 being all that comes through one of its faces.
///                   Gets phi: 1 is the mean over all directions of a light of which such a face gets all
/// O(cells). The same bits for any thread count and instruction set.
void diffuseLight(const GridShape& shape, const AlignedArray<float>& density, Float4 extinction,
    DiffusionWorkspace& room, AlignedArray<float>& light);

/// How much a sun's light counts where what is scattered many times is added to it: a thick body of white smoke is four
/// times as bright as its first scattering is, and then as bright as white paper.
/// @param multiple light.multiple_scattering
[[nodiscard]] float shareOfSun(float multiple);

/// Fills the diffuse light of a grid by its sun, sky and ground, and takes the sun down by shareOfSun(). Where
/// light.multiple_scattering is 0, or the grid has one cell, there is none.
void scatterManyTimes(const Light& light, LightWorkspace& room, LightGrid& grid);

/// The same for up to four suns of intensity 1 at once, added to what there is of them.
/// @param through four floats a cell: what is left of each sun in its middle; is written over
/// @param to      four floats a cell, of the same suns
void addScatteredManyTimes(const Light& light, const LightGrid& grid, LightWorkspace& room,
    AlignedArray<float>& through, AlignedArray<float>& to);

} // namespace fumage
