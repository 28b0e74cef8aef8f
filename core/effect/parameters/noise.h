#pragma once

#include "core/effect/parameters/row.h"

namespace fumage {

inline constexpr std::array<std::string_view, 3> kNoiseBases{"lattice", "gradient", "simplex"};
inline constexpr std::array<std::string_view, 4> kInterpolations{"linear", "cosine", "cubic", "quintic"};

template <>
inline constexpr Group<Noise> kGroup<Noise>{&Effect::noise, "noise", "Noise"};

template <>
inline constexpr std::array kRows<Noise>{
    row<&Noise::octaves>({
        .key = "noise.octaves",
        .label = "Octaves",
        .synonyms = "detail layers fractal levels fine",
        .hard = {1, 10},
        .soft = {1, 8},
        .step = 1,
        .tip = "Layers of noise that are summed, each finer and weaker than the one before.",
        .source = "2012 model, octaves",
        .stage = Stage::Noise,
    }),
    row<&Noise::sharpness>({
        .key = "noise.sharpness",
        .label = "Sharpness",
        .synonyms = "sharp crisp contrast hard soft",
        .hard = {0.05, 20},
        .soft = {0.25, 6},
        .step = 0.05,
        .scale = Scale::Log,
        .tip = "Contrast of the grey values about their middle; 1 leaves them as they are.",
        .source = "2012 model, sharpness",
        .stage = Stage::Noise,
    }),
    row<&Noise::wavelength>({
        .key = "noise.wavelength",
        .label = "Wavelength",
        .synonyms = "frequency scale size coarse fine",
        .hard = {0.005, 1},
        .soft = {0.05, 1},
        .step = 0.01,
        .scale = Scale::Log,
        .tip = "Wavelength of the first octave as a share of the tile (the inverse of its frequency).",
        .source = "2012 model, octaves",
        .stage = Stage::Noise,
    }),
    row<&Noise::persistence>({
        .key = "noise.persistence",
        .label = "Persistence",
        .synonyms = "gain amplitude roughness detail",
        .hard = kUnit,
        .step = 0.01,
        .tip = "Amplitude of each octave relative to the one before.",
        .source = "2012 model, octaves",
        .stage = Stage::Noise,
    }),
    row<&Noise::coverage>({
        .key = "noise.coverage",
        .label = "Coverage",
        .synonyms = "threshold amount fill bias",
        .hard = kUnit,
        .step = 0.01,
        .tip = "How much of the tile is smoke: shifts the grey values up or down.",
        .stage = Stage::Noise,
    }),
    row<&Noise::warp>({
        .key = "noise.warp",
        .label = "Warp",
        .synonyms = "distort bend domain swirl",
        .hard = {0, 2},
        .soft = {0, 0.6},
        .step = 0.01,
        .tip = "Bends the noise by another noise, by up to this share of its wavelength.",
        .source = "Perlin 1985, domain perturbation",
        .stage = Stage::Noise,
    }),
    row<&Noise::smooth>({
        .key = "noise.smooth",
        .label = "Smooth",
        .synonyms = "blur soft",
        .hard = kUnit,
        .step = 0.01,
        .tip = "Averages each lattice value with its neighbours: centre 1/4, edges 1/8, corners 1/16.",
        .source = "2012 model, smooth function",
        .visible = when("noise.basis", NoiseBasis::Lattice),
        .stage = Stage::Noise,
    }),
    row<&Noise::basis>({
        .key = "noise.basis",
        .label = "Basis",
        .synonyms = "type perlin simplex value",
        .tip = "Random values on a lattice (2012 model), random gradients, or gradients on a lattice of simplices.",
        .source = "2012 model; Perlin 2002",
        .choices = kNoiseBases,
        .stage = Stage::Noise,
    }),
    row<&Noise::interpolation>({
        .key = "noise.interpolation",
        .label = "Interpolation",
        .synonyms = "smooth linear cosine cubic",
        .tip = "How values between lattice points are found. Cubic swings past its points; what leaves "
               "0 to 1 is cut.",
        .source = "2012 model (linear, cosine, cubic); Perlin 2002 (quintic)",
        .choices = kInterpolations,
        .stage = Stage::Noise,
    }),
    row<&Noise::lacunarity>({
        .key = "noise.lacunarity",
        .label = "Lacunarity",
        .synonyms = "frequency detail",
        .hard = {1, 8},
        .soft = {1.5, 3},
        .step = 0.05,
        .tip = "Frequency of each octave relative to the one before.",
        .source = "2012 model, octaves",
        .stage = Stage::Noise,
    }),
    row<&Noise::depth>({
        .key = "noise.depth",
        .label = "Depth",
        .synonyms = "boil evolve third",
        .hard = {1, 64},
        .soft = {1, 16},
        .step = 1,
        .tip = "Lattice cells of the first octave along the third axis, through which the texture boils before it "
               "repeats.",
        .stage = Stage::Noise,
    }),
    row<&Noise::slices>({
        .key = "noise.slices",
        .label = "Slices",
        .synonyms = "layers quality",
        .hard = {1, kMaxNoiseSlices},
        .soft = {1, 64},
        .step = 1,
        .tip = "How many slices of the 3D noise are baked.",
        .stage = Stage::Noise,
    }),
    row<&Noise::resolution>({
        .key = "noise.resolution",
        .label = "Resolution",
        .synonyms = "size pixels quality detail",
        .hard = {8, kMaxNoiseResolution},
        .soft = {32, 256},
        .step = 32,
        .unit = Unit::Pixels,
        .tip = "Edge of the noise tile; particles use the next power of two.",
        .stage = Stage::Noise,
    }),
    row<&Noise::seed>({
        .key = "noise.seed",
        .label = "Seed",
        .synonyms = "random different another",
        .hard = kSeeds,
        .step = 1,
        .tip = "Another seed gives another texture of the same kind.",
        .stage = Stage::Noise,
    }),
};

} // namespace fumage
