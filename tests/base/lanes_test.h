#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>

// What the formulas of lanes_test.cpp read and write.
namespace fumage::tests {

inline constexpr std::size_t kLaneCount = 64; ///< a multiple of every vector's lanes
inline constexpr std::size_t kFormulas = 16;

using LaneColumn = std::array<float, kLaneCount>;

struct VectorInput {
    alignas(64) LaneColumn px, py, pz, qx, qy, qz;
    glm::vec3 same{1.7F, -0.3F, 23.1F};
    float factor = -2.37F;
};

struct VectorRow {
    alignas(64) LaneColumn x, y, z;
};
using VectorRows = std::array<VectorRow, kFormulas>;

struct HashInput {
    alignas(64) std::array<std::uint32_t, kLaneCount> low, high;
    std::uint32_t seed = 77;
    std::uint32_t stream = 5;
};

struct HashRows {
    alignas(64) std::array<std::uint32_t, kLaneCount> key, mixed, masked;
    alignas(64) LaneColumn unit, both;
};

struct MathRows {
    alignas(64) LaneColumn sine, cosine, exponential, logarithm;
};

} // namespace fumage::tests
