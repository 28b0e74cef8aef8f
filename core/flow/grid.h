#pragma once

#include "core/base/aligned_array.h"

#include <array>
#include <cstddef>

#include <glm/vec3.hpp>

namespace fumage {

/// Fewest and most cells along an edge of the air: kernels have room for a row of as many.
inline constexpr int kMinAirCells = 8;
inline constexpr int kMaxAirCells = 128;

/// Floats that a row of cells is padded to: the widest vector.
inline constexpr std::size_t kAirLanes = 16;

/// Whether a test holds for any of the cells below n, those along x first.
template <class Test>
bool anyCell(const glm::ivec3& n, const Test& test)
{
    for (int k = 0; k < n.z; ++k) {
        for (int j = 0; j < n.y; ++j) {
            for (int i = 0; i < n.x; ++i) {
                if (test(glm::ivec3(i, j, k))) {
                    return true;
                }
            }
        }
    }
    return false;
}

/// Calls visit(cell) for all cells below n, those along x first.
template <class Visit>
void forCells(const glm::ivec3& n, const Visit& visit)
{
    anyCell(n, [&](const glm::ivec3& cell) {
        visit(cell);
        return false;
    });
}

/// Cells of a grid from low up to, and without, high.
struct CellBox {
    glm::ivec3 low{0};
    glm::ivec3 high{0};
};

/// Calls visit(cell) for all cells of a box, those along x first.
template <class Visit>
void forCellsOf(const CellBox& box, const Visit& visit)
{
    forCells(box.high - box.low, [&](const glm::ivec3& within) { visit(box.low + within); });
}

/// Where the air is: a box of cubic cells.
struct AirGrid {
    glm::ivec3 cells{0}; ///< each kMinAirCells to kMaxAirCells
    float cell = 1.0F; ///< edge of one, m
    glm::vec3 corner{0.0F}; ///< where the box begins, m
    friend bool operator==(const AirGrid&, const AirGrid&) = default;

    /// m
    [[nodiscard]] glm::vec3 size() const { return cell * glm::vec3(cells); }

    /// Where the box ends, m.
    [[nodiscard]] glm::vec3 end() const { return corner + size(); }

    /// The middle of a cell, m.
    [[nodiscard]] glm::vec3 centre(const glm::ivec3& of) const { return corner + cell * (glm::vec3(of) + 0.5F); }
};

/// What a side of the box is: air goes through, with the pressure of outside on the face; or a wall that it slides
/// along.
enum class Boundary {
    Open,
    Solid
};

struct AirBoundaries {
    std::array<Boundary, 3> low{}; ///< towards -x, -y, -z
    std::array<Boundary, 3> high{};
    friend bool operator==(const AirBoundaries&, const AirBoundaries&) = default;

    /// No way out: the pressure has then no level of its own, and what is put in stays.
    [[nodiscard]] bool closed() const
    {
        constexpr std::array kWalls{Boundary::Solid, Boundary::Solid, Boundary::Solid};
        return low == kWalls && high == kWalls;
    }
};

/// One number a cell, with a ring of ghosts outside the box. A row begins at a multiple of kAirLanes and has room for
/// whole vectors, so that kernels load and store whole ones; a ghost before a row stands in the padding of the one
/// before it.
struct ColumnLayout {
    explicit ColumnLayout(const glm::ivec3& of)
        : cells(of)
        , row(rounded(static_cast<std::size_t>(of.x) + 2))
        , plane(row * (static_cast<std::size_t>(of.y) + 2))
        , origin(plane + row + kAirLanes)
        , size(plane * (static_cast<std::size_t>(of.z) + 2) + 2 * kAirLanes)
    {
    }

    glm::ivec3 cells;
    std::size_t row; ///< from a cell to the one above
    std::size_t plane; ///< from a cell to the next along z
    std::size_t origin; ///< cell (0, 0, 0)
    std::size_t size;

    /// @param i,j,k from -1 to cells
    [[nodiscard]] std::size_t at(int i, int j, int k) const
    {
        return origin + static_cast<std::size_t>(i) + static_cast<std::size_t>(j) * row
            + static_cast<std::size_t>(k) * plane;
    }

    /// Where the numbers of a plane begin, ghosts and padding included.
    /// @param k from -1 to cells + 1, which is their end
    [[nodiscard]] std::ptrdiff_t planeStart(int k) const { return (k + 1) * static_cast<std::ptrdiff_t>(plane); }

private:
    static constexpr std::size_t rounded(std::size_t count) { return (count + kAirLanes - 1) / kAirLanes * kAirLanes; }
};

/// Four numbers a cell, (u, v, w, heat), side by side: one fetch gets all of a corner. With a ring of ghosts too.
struct QuadLayout {
    explicit QuadLayout(const glm::ivec3& of)
        : row(4 * ((static_cast<std::size_t>(of.x) + kAirLanes - 1) / kAirLanes * kAirLanes + 2))
        , plane(row * (static_cast<std::size_t>(of.y) + 2))
        , origin(plane + row + 4)
        , size(plane * (static_cast<std::size_t>(of.z) + 2) + 4 * kAirLanes)
    {
    }

    std::size_t row; ///< floats from a cell to the one above
    std::size_t plane;
    std::size_t origin;
    std::size_t size;

    [[nodiscard]] std::size_t at(int i, int j, int k) const
    {
        return origin + 4 * static_cast<std::size_t>(i) + static_cast<std::size_t>(j) * row
            + static_cast<std::size_t>(k) * plane;
    }
};

/// Four numbers a node, the corners of cells, x fastest; as many as whole vectors hold.
struct NodeLayout {
    NodeLayout() = default;
    explicit NodeLayout(const glm::ivec3& cells)
        : row(4 * static_cast<std::size_t>(cells.x + 1))
        , plane(row * static_cast<std::size_t>(cells.y + 1))
        , size(roundUp(plane * static_cast<std::size_t>(cells.z + 1), kPadding))
    {
    }

    static constexpr std::size_t kPadding = 32;

    std::size_t row = 0; ///< numbers from a node to the one above
    std::size_t plane = 0;
    std::size_t size = 0;
};

} // namespace fumage
