#include "core/export/data/vdb_tree.h"

#include <utility>

#include <glm/common.hpp>

namespace fumage::vdb {

namespace {

/// The place of a child: x counts most.
std::size_t placeOf(const glm::ivec3& at, int bits)
{
    const unsigned edge = (1U << static_cast<unsigned>(bits)) - 1U;
    const auto part = [&](int along) { return static_cast<std::size_t>(static_cast<unsigned>(along) & edge); };
    return (part(at.x) << static_cast<unsigned>(2 * bits)) | (part(at.y) << static_cast<unsigned>(bits)) | part(at.z);
}

/// Voxels from low to high.
struct Box {
    glm::ivec3 low{0};
    glm::ivec3 high{0};
};

/// Calls visit(child) for the children of a node that touch a box.
/// @param first      voxel of the node
/// @param bits       log2 of its children along an edge
/// @param bitsOfEdge log2 of the voxels of a child along an edge
template <class Visit>
void forChildrenIn(const Box& box, const glm::ivec3& first, int bits, int bitsOfEdge, const Visit& visit)
{
    const glm::ivec3 most((1 << bits) - 1);
    forChildren(glm::max((box.low - first) >> bitsOfEdge, 0), glm::min((box.high - first) >> bitsOfEdge, most), visit);
}

Leaf leafOf(const Placed& placed, const Box& box, const glm::ivec3& first, Tree& tree)
{
    Leaf leaf;
    leaf.first = first;
    forChildrenIn(box, first, kLeafBits, 0, [&](const glm::ivec3& voxelAt) {
        const glm::ivec3 voxel = first + voxelAt;
        if (placed.at(voxel)) {
            leaf.voxels.set(placeOf(voxelAt, kLeafBits));
            ++tree.voxels;
            tree.low = glm::min(tree.low, voxel);
            tree.high = glm::max(tree.high, voxel);
        }
    });
    return leaf;
}

Top topOf(const Placed& placed, const Box& box, const glm::ivec3& first, Tree& tree)
{
    Top top;
    top.first = first;
    forChildrenIn(box, first, kTopBits, kLeafBits + kMiddleBits, [&](const glm::ivec3& middleAt) {
        Middle middle;
        middle.place = placeOf(middleAt, kTopBits);
        const glm::ivec3 middleFirst = first + middleAt * (1 << (kLeafBits + kMiddleBits));
        forChildrenIn(box, middleFirst, kMiddleBits, kLeafBits, [&](const glm::ivec3& leafAt) {
            const std::int64_t before = tree.voxels;
            Leaf leaf = leafOf(placed, box, middleFirst + leafAt * (1 << kLeafBits), tree);
            if (tree.voxels > before) {
                middle.children.set(placeOf(leafAt, kMiddleBits));
                middle.leaves.push_back(std::move(leaf));
            }
        });
        if (!middle.leaves.empty()) {
            top.children.set(middle.place);
            top.middles.push_back(std::move(middle));
        }
    });
    return top;
}

} // namespace

Tree treeOf(const Placed& placed)
{
    constexpr int kBits = kLeafBits + kMiddleBits + kTopBits;
    const Box box{placed.first(), placed.first() + placed.cells() - 1};
    Tree tree;
    tree.low = box.high + 1;
    tree.high = box.low - 1;
    if (placed.cells() == glm::ivec3(0)) {
        return tree;
    }
    forChildren(box.low >> kBits, box.high >> kBits, [&](const glm::ivec3& topAt) {
        Top top = topOf(placed, box, topAt * (1 << kBits), tree);
        if (!top.middles.empty()) {
            tree.tops.push_back(std::move(top));
        }
    });
    return tree;
}

} // namespace fumage::vdb
