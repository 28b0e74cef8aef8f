#pragma once

#include "core/export/data/up_axis.h"
#include "core/export/data/volume.h"

#include <optional>
#include <string>
#include <vector>

namespace fumage::vdb {

/// Log2 of the children along an edge, from the root down; a leaf has voxels.
inline constexpr int kLeafBits = 3;
inline constexpr int kMiddleBits = 4;
inline constexpr int kTopBits = 5;

/// Bits, one a child, the lowest first.
class Mask {
public:
    explicit Mask(int bitsOfEdge)
        : m_bytes((std::size_t{1} << static_cast<unsigned>(3 * bitsOfEdge)) / 8, '\0')
    {
    }
    void set(std::size_t at)
    {
        m_bytes[at / 8] = static_cast<char>(static_cast<unsigned char>(m_bytes[at / 8]) | 1U << at % 8);
    }
    [[nodiscard]] const std::string& bytes() const { return m_bytes; }

private:
    std::string m_bytes;
};

/// Which leaves there are, and which of their voxels.
struct Leaf {
    glm::ivec3 first{0}; ///< voxel
    Mask voxels{kLeafBits};
};
struct Middle {
    std::size_t place = 0; ///< among the children of the top
    Mask children{kMiddleBits};
    std::vector<Leaf> leaves; ///< by their place
};
struct Top {
    glm::ivec3 first{0}; ///< voxel
    Mask children{kTopBits};
    std::vector<Middle> middles; ///< by their place
};
struct Tree {
    std::vector<Top> tops; ///< from the lowest x, then y, then z
    std::int64_t voxels = 0;
    glm::ivec3 low{0}, high{0}; ///< of the voxels
};

/// The volume in a file's axes. Both must stay.
class Placed {
public:
    /// @param density of the volume, or of one of its layers: there are voxels where there is some
    Placed(const Volume& volume, const std::vector<float>& density, UpAxis up)
        : m_volume(volume)
        , m_density(density)
        , m_up(up)
    {
    }

    [[nodiscard]] glm::ivec3 cells() const
    {
        return m_up == UpAxis::Z ? glm::ivec3(m_volume.cells.x, m_volume.cells.z, m_volume.cells.y) : m_volume.cells;
    }
    /// The voxel at the corner of the box. What is turned over has voxel -1 where voxel 0 was.
    [[nodiscard]] glm::ivec3 first() const
    {
        const glm::ivec3& ours = m_volume.first;
        return m_up == UpAxis::Z ? glm::ivec3(ours.x, -ours.z - m_volume.cells.z, ours.y) : ours;
    }
    /// Where the numbers of a voxel stand; nothing where it has no smoke, or lies outside of the volume.
    [[nodiscard]] std::optional<std::size_t> at(const glm::ivec3& voxel) const
    {
        const glm::ivec3 inside = voxel - first();
        const glm::ivec3 ours =
            m_up == UpAxis::Z ? glm::ivec3(inside.x, inside.z, m_volume.cells.z - 1 - inside.y) : inside;
        for (int axis = 0; axis < 3; ++axis) {
            if (ours[axis] < 0 || ours[axis] >= m_volume.cells[axis]) {
                return std::nullopt;
            }
        }
        const auto size = [&](int along) { return static_cast<std::size_t>(along); };
        const std::size_t place =
            size(ours.x) + size(m_volume.cells.x) * (size(ours.y) + size(m_volume.cells.y) * size(ours.z));
        return m_density[place] > 0.0F ? std::optional(place) : std::nullopt;
    }

private:
    const Volume& m_volume;
    const std::vector<float>& m_density;
    UpAxis m_up;
};

/// Calls visit(i, j, k) for all from low to high, k fastest, as children of nodes are counted.
template <class Visit>
void forChildren(const glm::ivec3& low, const glm::ivec3& high, const Visit& visit)
{
    for (int i = low.x; i <= high.x; ++i) {
        for (int j = low.y; j <= high.y; ++j) {
            for (int k = low.z; k <= high.z; ++k) {
                visit(glm::ivec3(i, j, k));
            }
        }
    }
}

/// The nodes of a volume as OpenVDB has them: those with smoke in them alone. O(voxels of the box).
[[nodiscard]] Tree treeOf(const Placed& placed);

} // namespace fumage::vdb
