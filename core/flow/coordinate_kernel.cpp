#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/flow/coordinate_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/flow/coordinate_kernel.h"
#include "core/flow/field-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// The coordinates of places, one a lane, as quads.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE void coordinatesAt(D d, const CoordinateMap& map, const LanePlaces<V>& at, float* HWY_RESTRICT quads)
{
    HWY_ALIGN float share[3][hn::MaxLanes(D())];
    store(at.beyond, share[0], share[1], share[2], 0);
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
        const Between between{share[0][lane], share[1][lane], share[2][lane]};
        for (std::size_t part = 0; part < 4; part += hn::Lanes(QuadTag())) {
            hn::StoreU(sampled(map.quads.data() + at.node[lane] + part, map.row, map.plane, between), QuadTag(),
                quads + 4 * lane + part);
        }
    }
}

void carryNodes(const CoordinateMap& from, const AirField& field, float seconds, int plane, CoordinateMap& to)
{
    using D = hn::ScalableTag<float>;
    using V = hn::Vec<D>;
    const D d;
    const AirGrid& grid = from.grid;
    const glm::vec3 end = grid.end();
    const int nodes = grid.cells.x + 1;
    HWY_ALIGN float quads[4 * hn::MaxLanes(D())];
    const auto velocityAt = [&](const Vec3<V>& place)
                                HWY_ATTR { return readLanes<false>(field, placesIn(d, field, place)).velocity; };
    const auto beyond = [&](V place, float low, float high)
                            HWY_ATTR { return place - hn::Min(hn::Max(place, hn::Set(d, low)), hn::Set(d, high)); };
    for (int j = 0; j <= grid.cells.y; ++j) {
        float* row =
            to.quads.data() + static_cast<std::size_t>(plane) * to.plane + static_cast<std::size_t>(j) * to.row;
        for (int i = 0; i < nodes; i += static_cast<int>(hn::Lanes(d))) {
            const Vec3<V> node{hn::Iota(d, static_cast<float>(i)) * grid.cell + grid.corner.x,
                hn::Set(d, static_cast<float>(j) * grid.cell + grid.corner.y),
                hn::Set(d, static_cast<float>(plane) * grid.cell + grid.corner.z)};
            const Vec3<V> middle = node - velocityAt(node) * (0.5F * seconds);
            const Vec3<V> start = node - velocityAt(middle) * seconds;
            coordinatesAt(d, from, placesIn(d, field, start), quads);
            Vec3<V> there;
            V unused;
            hn::LoadInterleaved4(d, quads, there.x, there.y, there.z, unused);
            const Vec3<V> outside{beyond(start.x, grid.corner.x, end.x), beyond(start.y, grid.corner.y, end.y),
                beyond(start.z, grid.corner.z, end.z)};
            there = there + outside;
            hn::StoreInterleaved4(there.x, there.y, there.z, unused, d, quads);
            // The row's last vector may be longer than the row, and the next row another thread's.
            std::copy_n(quads, 4 * std::min(nodes - i, static_cast<int>(hn::Lanes(d))), row + 4 * i);
        }
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(carryNodes);

void carryPlane(const CoordinateMap& from, const AirField& field, float seconds, int plane, CoordinateMap& to)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(carryNodes);
    kernel(from, field, seconds, plane, to);
}

} // namespace fumage
#endif
