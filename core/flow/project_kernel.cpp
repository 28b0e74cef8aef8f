#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/flow/project_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/vector-inl.h"
#include "core/flow/halfs-inl.h"
#include "core/flow/project_kernel.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::CappedTag<float, kAirLanes>;
using V = hn::Vec<D>;

/// Velocities along one axis through the lower faces of cells, before or after the pressure has acted.
struct Faces {
    const float* velocity;
    const float* pressure; ///< null: before
    const float* open; ///< null: no obstacles
    std::size_t stride;

    [[nodiscard]] HWY_INLINE V at(D d, std::size_t cell) const
    {
        V through = 0.5F * (hn::LoadU(d, velocity + cell) + hn::LoadU(d, velocity + cell - stride));
        if (pressure != nullptr) {
            through = through - (hn::LoadU(d, pressure + cell) - hn::LoadU(d, pressure + cell - stride));
        }
        return open == nullptr ? through : through * hn::LoadU(d, open + cell);
    }
};

/// The three kinds of faces of a cell.
struct AllFaces {
    AllFaces(const AirCells& cells, bool after)
        : x(facesOf(cells, cells.forced.x, cells.open.x, 1, after))
        , y(facesOf(cells, cells.forced.y, cells.open.y, cells.column.row, after))
        , z(facesOf(cells, cells.forced.z, cells.open.z, cells.column.plane, after))
    {
    }

    Faces x, y, z;

private:
    static Faces facesOf(const AirCells& cells, const AirColumn& velocity, const AirColumn& open, std::size_t stride, bool after)
    {
        return {velocity.data(), after ? cells.pressure.data() : nullptr, open.empty() ? nullptr : open.data(), stride};
    }
};

void divergencePlane(AirCells& cells, int k)
{
    const D d;
    const AllFaces faces(cells, false);
    const auto n = static_cast<std::size_t>(cells.grid.cells.x);
    const auto outOf = [&](const Faces& face, std::size_t at) HWY_ATTR { return face.at(d, at + face.stride) - face.at(d, at); };
    for (int j = 0; j < cells.grid.cells.y; ++j) {
        const std::size_t start = cells.column.at(0, j, k);
        for (std::size_t at = start; at < start + n; at += hn::Lanes(d)) {
            V sum = outOf(faces.x, at) + outOf(faces.y, at) + outOf(faces.z, at) - hn::Load(d, cells.divergence.data() + at);
            if (cells.hasObstacles()) {
                sum = sum * hn::Load(d, cells.fluid.data() + at);
            }
            hn::Store(sum, d, cells.divergence.data() + at);
        }
    }
}

/// The mean of the pressure's differences across the two faces of a cell.
HWY_INLINE V gradient(D d, const Faces& faces, std::size_t at)
{
    const V here = hn::LoadU(d, faces.pressure + at);
    V above = hn::LoadU(d, faces.pressure + at + faces.stride) - here;
    V below = here - hn::LoadU(d, faces.pressure + at - faces.stride);
    if (faces.open != nullptr) {
        above = above * hn::LoadU(d, faces.open + at + faces.stride);
        below = below * hn::LoadU(d, faces.open + at);
    }
    return 0.5F * (below + above);
}

/// The mean of the velocities through the two faces of a cell.
HWY_INLINE V through(D d, const Faces& faces, std::size_t at)
{
    return 0.5F * (faces.at(d, at) + faces.at(d, at + faces.stride));
}

/// 0 where a number is less than anybody sees: what thins out from cell to cell without end would else reach the denormal numbers, which take
/// processors a hundred times as long.
HWY_INLINE V withoutTraces(D d, V value)
{
    constexpr float kTrace = 1e-9F; // m/s, or of the heat of the source
    return hn::IfThenElseZero(hn::Ge(hn::Abs(value), hn::Set(d, kTrace)), value);
}

void gradientPlane(AirCells& cells, int k)
{
    const D d;
    const AllFaces faces(cells, true);
    const auto n = static_cast<std::size_t>(cells.grid.cells.x);
    for (int j = 0; j < cells.grid.cells.y; ++j) {
        const std::size_t start = cells.column.at(0, j, k);
        float* quads = cells.air.data() + cells.quad.at(0, j, k);
        float* carriers = cells.carrier.data() + cells.quad.at(0, j, k);
        for (std::size_t i = 0; i < n; i += hn::Lanes(d)) {
            const std::size_t at = start + i;
            const Vec3<V> forced = load(d, cells.forced.x, cells.forced.y, cells.forced.z, at);
            const Vec3<V> v = forced - Vec3<V>{gradient(d, faces.x, at), gradient(d, faces.y, at), gradient(d, faces.z, at)};
            const Vec3<V> carrying{through(d, faces.x, at), through(d, faces.y, at), through(d, faces.z, at)};
            hn::StoreInterleaved4(withoutTraces(d, carrying.x), withoutTraces(d, carrying.y), withoutTraces(d, carrying.z), hn::Zero(d), d, carriers + 4 * i);
            const V heat = hn::Load(d, cells.heat.data() + at);
            hn::StoreInterleaved4(withoutTraces(d, v.x), withoutTraces(d, v.y), withoutTraces(d, v.z), withoutTraces(d, heat), d, quads + 4 * i);
        }
        // What whole vectors have left in the padding differs from one instruction set to the next, and the state may not.
        std::fill(quads + 4 * (n + 1), quads + cells.quad.row - 4, 0.0F);
        std::fill(carriers + 4 * (n + 1), carriers + cells.quad.row - 4, 0.0F);
    }
}

/// How much of the faces before, at and behind a node goes into it: the mean over three, and on the border that of the face itself.
struct Smoothing {
    Smoothing(int node, int last)
        : beside(node == 0 || node == last ? 0.0F : 0.25F)
        , own(1.0F - 2.0F * beside)
    {
    }

    float beside, own;
};

constexpr std::size_t kRowRoom = kMaxAirCells + 2 * kAirLanes;

/// Columns of one row of nodes, each with a place before its first.
struct NodeRow {
    HWY_ALIGN float faces[kAirLanes + kRowRoom];
    HWY_ALIGN float quads[4 * kRowRoom];
    HWY_ALIGN std::uint16_t halfs[4 * kRowRoom];
};

/// The mean of four rows of faces across x, around a row of nodes, smoothed along it.
HWY_INLINE void alongX(D d, const AirCells& cells, const Faces& faces, std::size_t nodeRow, NodeRow& room)
{
    const auto last = static_cast<std::size_t>(cells.grid.cells.x);
    float* HWY_RESTRICT mean = room.faces + kAirLanes;
    for (std::size_t i = 0; i <= last; i += hn::Lanes(d)) {
        const std::size_t at = nodeRow + i;
        const V near = faces.at(d, at) + faces.at(d, at - cells.column.row);
        const V far = faces.at(d, at - cells.column.plane) + faces.at(d, at - cells.column.plane - cells.column.row);
        hn::Store(0.25F * (near + far), d, mean + i);
    }
    // Beyond the ends as if it went on straight: the smoothed value of the border is then that of its face.
    mean[-1] = 2.0F * mean[0] - mean[1];
    mean[last + 1] = 2.0F * mean[last] - mean[last - 1];
    for (std::size_t i = 0; i <= last; i += hn::Lanes(d)) {
        const V sides = hn::LoadU(d, mean + i - 1) + hn::LoadU(d, mean + i + 1);
        hn::Store(0.25F * sides + 0.5F * hn::Load(d, mean + i), d, room.quads + i);
    }
}

/// The same across y or z, for one vector of nodes.
/// @param other stride of the axis that is neither x nor that of the faces
HWY_INLINE V acrossX(D d, const Faces& faces, const Smoothing& smoothing, std::size_t other, std::size_t at)
{
    const auto mean = [&](std::size_t face) HWY_ATTR { return 0.25F * ((faces.at(d, face) + faces.at(d, face - 1)) + (faces.at(d, face - other) + faces.at(d, face - other - 1))); };
    V out = smoothing.own * mean(at);
    if (smoothing.beside != 0.0F) {
        out = out + smoothing.beside * (mean(at - faces.stride) + mean(at + faces.stride));
    }
    return out;
}

HWY_INLINE V heatOfNode(D d, const AirCells& cells, std::size_t at)
{
    const float* heat = cells.heat.data() + at;
    const auto pair = [&](const float* of) HWY_ATTR { return hn::LoadU(d, of) + hn::LoadU(d, of - 1); };
    const std::size_t row = cells.column.row;
    const std::size_t plane = cells.column.plane;
    return 0.125F * ((pair(heat) + pair(heat - row)) + (pair(heat - plane) + pair(heat - plane - row)));
}

void nodePlane(const AirCells& cells, AirField& field, int k)
{
    const D d;
    const AllFaces faces(cells, true);
    const glm::ivec3 n = cells.grid.cells;
    const auto nodes = static_cast<std::size_t>(n.x) + 1;
    NodeRow room;
    const Smoothing z(k, n.z);
    for (int j = 0; j <= n.y; ++j) {
        const Smoothing y(j, n.y);
        const std::size_t start = cells.column.at(0, j, k);
        alongX(d, cells, faces.x, start, room);
        HWY_ALIGN float u[kRowRoom];
        std::copy_n(room.quads, kRowRoom, u);
        for (std::size_t i = 0; i < nodes; i += hn::Lanes(d)) {
            const std::size_t at = start + i;
            const V v = acrossX(d, faces.y, y, cells.column.plane, at);
            const V w = acrossX(d, faces.z, z, cells.column.row, at);
            hn::StoreInterleaved4(hn::Load(d, u + i), v, w, heatOfNode(d, cells, at), d, room.quads + 4 * i);
        }
        for (std::size_t i = 0; i < 4 * nodes; i += hn::Lanes(d)) {
            storeHalfs(hn::Load(d, room.quads + i), room.halfs + i);
        }
        std::copy_n(room.halfs, field.row, field.quads.data() + static_cast<std::size_t>(j) * field.row + static_cast<std::size_t>(k) * field.plane);
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(divergencePlane);
HWY_EXPORT(gradientPlane);
HWY_EXPORT(nodePlane);

void findDivergence(AirCells& cells, int k)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(divergencePlane);
    kernel(cells, k);
}

void subtractGradient(AirCells& cells, int k)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(gradientPlane);
    kernel(cells, k);
}

void writeNodes(const AirCells& cells, AirField& field, int k)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(nodePlane);
    kernel(cells, field, k);
}

} // namespace fumage
#endif
