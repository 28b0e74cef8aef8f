#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/flow/project_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/vector-inl.h"
#include "core/flow/halves-inl.h"
#include "core/flow/project_kernel.h"
#include "core/flow/speed-inl.h"

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
    const float* wall; ///< velocity of those faces that obstacles close; null: no obstacle moves
    std::size_t stride;

    template <class D>
    [[nodiscard]] HWY_INLINE hn::VFromD<D> at(D d, std::size_t cell) const
    {
        auto through = 0.5F * (hn::LoadU(d, velocity + cell) + hn::LoadU(d, velocity + cell - stride));
        if (pressure != nullptr) {
            through = through - (hn::LoadU(d, pressure + cell) - hn::LoadU(d, pressure + cell - stride));
        }
        if (open != nullptr) {
            through = through * hn::LoadU(d, open + cell);
        }
        return wall == nullptr ? through : through + hn::LoadU(d, wall + cell);
    }
};

/// The three kinds of faces of a cell.
struct AllFaces {
    /// @param k plane of cells; of faces those beside it may be asked for, too
    AllFaces(const AirCells& cells, bool after, int k)
        : x(facesOf(cells, &AirVectors::x, 1, after, k))
        , y(facesOf(cells, &AirVectors::y, cells.column.row, after, k))
        , z(facesOf(cells, &AirVectors::z, cells.column.plane, after, k))
    {
    }

    Faces x, y, z;

private:
    static Faces facesOf(const AirCells& cells, AirColumn AirVectors::*axis, std::size_t stride, bool after, int k)
    {
        const AirColumn& open = cells.open.*axis;
        const AirColumn& wall = cells.wall.*axis;
        return {(cells.forced.*axis).data(), after ? cells.pressure.data() : nullptr,
            open.empty() ? nullptr : open.data(), cells.hasMovingWallsBeside(k) ? wall.data() : nullptr, stride};
    }
};

void divergencePlane(AirCells& cells, int k)
{
    const D d;
    const AllFaces faces(cells, false, k);
    const auto n = static_cast<std::size_t>(cells.grid.cells.x);
    const auto outOf = [&](const Faces& face, std::size_t at)
                           HWY_ATTR { return face.at(d, at + face.stride) - face.at(d, at); };
    for (int j = 0; j < cells.grid.cells.y; ++j) {
        const std::size_t start = cells.column.at(0, j, k);
        for (std::size_t at = start; at < start + n; at += hn::Lanes(d)) {
            V sum = outOf(faces.x, at) + outOf(faces.y, at) + outOf(faces.z, at)
                - hn::Load(d, cells.divergence.data() + at);
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

/// 0 where a number is less than anybody sees: what thins out from cell to cell without end would else reach the
/// denormal numbers, which take processors a hundred times as long.
HWY_INLINE V withoutTraces(D d, V value)
{
    constexpr float kTrace = 1e-9F; // m/s, or of the heat of the source
    return hn::IfThenElseZero(hn::Ge(hn::Abs(value), hn::Set(d, kTrace)), value);
}

void gradientPlane(AirCells& cells, int k)
{
    const D d;
    const AllFaces faces(cells, true, k);
    const auto n = static_cast<std::size_t>(cells.grid.cells.x);
    for (int j = 0; j < cells.grid.cells.y; ++j) {
        const std::size_t start = cells.column.at(0, j, k);
        float* quads = cells.air.data() + cells.quad.at(0, j, k);
        float* carriers = cells.carrier.data() + cells.quad.at(0, j, k);
        for (std::size_t i = 0; i < n; i += hn::Lanes(d)) {
            const std::size_t at = start + i;
            const Vec3<V> forced = load(d, cells.forced.x, cells.forced.y, cells.forced.z, at);
            const Vec3<V> v = boundedSpeed(
                d, forced - Vec3<V>{gradient(d, faces.x, at), gradient(d, faces.y, at), gradient(d, faces.z, at)});
            const Vec3<V> carrying =
                boundedSpeed(d, Vec3<V>{through(d, faces.x, at), through(d, faces.y, at), through(d, faces.z, at)});
            hn::StoreInterleaved4(withoutTraces(d, carrying.x), withoutTraces(d, carrying.y),
                withoutTraces(d, carrying.z), hn::Zero(d), d, carriers + 4 * i);
            const V heat = hn::Load(d, cells.heat.data() + at);
            hn::StoreInterleaved4(withoutTraces(d, v.x), withoutTraces(d, v.y), withoutTraces(d, v.z),
                withoutTraces(d, heat), d, quads + 4 * i);
        }
        // What whole vectors have left in the padding differs from one instruction set to the next, and the state may
        // not.
        std::fill(quads + 4 * (n + 1), quads + cells.quad.row - 4, 0.0F);
        std::fill(carriers + 4 * (n + 1), carriers + cells.quad.row - 4, 0.0F);
    }
}

/// How much of the faces before, at and behind a node goes into it: the mean over three, and on the border that of the
/// face itself.
struct Smoothing {
    Smoothing(int node, int last)
        : beside(node == 0 || node == last ? 0.0F : 0.25F)
        , own(1.0F - 2.0F * beside)
    {
    }

    float beside, own;
};

constexpr std::size_t kRowRoom = kMaxAirCells + 2 * kAirLanes;

/// The latest rows of numbers of cells or faces: a row of nodes shares most of what it needs with the one before it.
template <int kRows>
struct LatestRows {
    HWY_ALIGN float row[kRows][kRowRoom];

    /// @param j -1 or more
    [[nodiscard]] HWY_INLINE float* at(int j) { return row[(j + kRows) % kRows]; }
    [[nodiscard]] HWY_INLINE const float* at(int j) const { return row[(j + kRows) % kRows]; }
};

/// Around a plane of nodes: of the planes of cells before and behind it, and of three planes of faces.
struct NodeRows {
    LatestRows<2> x[2]; ///< faces across x
    LatestRows<2> heat[2]; ///< sums of a cell and the one before it
    LatestRows<2> z[3]; ///< sums of a face across z and the one before it
    LatestRows<3> y; ///< means of the four faces across y around a node
};

/// Calls body(d, i) for numbers i and those after it of all nodes of a row, one more than there are cells: where it is
/// a few that are left over, with a vector of fewer lanes.
template <class Body>
HWY_INLINE void forNodes(std::size_t nodes, const Body& body)
{
    const D d;
    const hn::CappedTag<float, 4> few;
    std::size_t i = 0;
    for (; i + hn::Lanes(few) < nodes; i += hn::Lanes(d)) {
        body(d, i);
    }
    for (; i < nodes; i += hn::Lanes(few)) {
        body(few, i);
    }
}

/// Sums of the faces of a row and those before them.
HWY_INLINE void storePairs(const Faces& faces, std::size_t start, std::size_t nodes, float* HWY_RESTRICT out)
{
    forNodes(nodes, [&](auto d, std::size_t i) HWY_ATTR {
        hn::Store(faces.at(d, start + i) + faces.at(d, start + i - 1), d, out + i);
    });
}

/// Row j of the cells around a plane of nodes, and of the faces across z.
/// @param beyond whether there are faces on both sides of the plane of nodes
HWY_INLINE void findRows(
    const AirCells& cells, const AllFaces& faces, std::size_t start, int j, bool beyond, NodeRows& rows)
{
    const std::size_t nodes = static_cast<std::size_t>(cells.grid.cells.x) + 1;
    const std::size_t plane = cells.column.plane;
    for (std::size_t side = 0; side < 2; ++side) {
        const std::size_t of = start + (side - 1) * plane;
        float* HWY_RESTRICT x = rows.x[side].at(j);
        float* HWY_RESTRICT sums = rows.heat[side].at(j);
        const float* HWY_RESTRICT heat = cells.heat.data() + of;
        forNodes(nodes, [&](auto d, std::size_t i) HWY_ATTR {
            hn::Store(faces.x.at(d, of + i), d, x + i);
            hn::Store(hn::LoadU(d, heat + i) + hn::LoadU(d, heat + i - 1), d, sums + i);
        });
    }
    for (std::size_t k = beyond ? 0 : 1; k < (beyond ? 3U : 2U); ++k) {
        storePairs(faces.z, start + (k - 1) * plane, nodes, rows.z[k].at(j));
    }
}

/// The means of four faces across y around the nodes of row j.
HWY_INLINE void findMeans(const AirCells& cells, const Faces& faces, std::size_t start, int j, NodeRows& rows)
{
    const std::size_t nodes = static_cast<std::size_t>(cells.grid.cells.x) + 1;
    const std::size_t plane = cells.column.plane;
    float* HWY_RESTRICT mean = rows.y.at(j);
    forNodes(nodes, [&](auto d, std::size_t i) HWY_ATTR {
        const std::size_t at = start + i;
        hn::Store(
            0.25F * ((faces.at(d, at) + faces.at(d, at - 1)) + (faces.at(d, at - plane) + faces.at(d, at - plane - 1))),
            d, mean + i);
    });
}

/// The means of four rows of faces across x around a row of nodes.
/// @param mean with a place before its first and one behind its last
HWY_INLINE void meansAlongX(const NodeRows& rows, int j, std::size_t last, float* HWY_RESTRICT mean)
{
    forNodes(last + 1, [&](auto d, std::size_t i) HWY_ATTR {
        const auto sum = [&](const LatestRows<2>& x)
                             HWY_ATTR { return hn::Load(d, x.at(j) + i) + hn::Load(d, x.at(j - 1) + i); };
        hn::Store(0.25F * (sum(rows.x[1]) + sum(rows.x[0])), d, mean + i);
    });
    // Beyond the ends as if it went on straight: the smoothed value of the border is then that of its face.
    mean[-1] = 2.0F * mean[0] - mean[1];
    mean[last + 1] = 2.0F * mean[last] - mean[last - 1];
}

/// Those smoothed along the row; some time after they were stored, since what is loaded across two of their vectors
/// waits until they are in the cache.
HWY_INLINE void smoothAlongX(std::size_t last, const float* HWY_RESTRICT mean, float* HWY_RESTRICT out)
{
    forNodes(last + 1, [&](auto d, std::size_t i) HWY_ATTR {
        const auto sides = hn::LoadU(d, mean + i - 1) + hn::LoadU(d, mean + i + 1);
        hn::Store(0.25F * sides + 0.5F * hn::Load(d, mean + i), d, out + i);
    });
}

/// The same across y or z.
/// @param mean of the faces around node i before, at and behind it: -1, 0 or 1
template <class Mean>
HWY_INLINE auto acrossX(const Smoothing& smoothing, const Mean& mean)
{
    auto out = smoothing.own * mean(0);
    if (smoothing.beside != 0.0F) {
        out = out + smoothing.beside * (mean(-1) + mean(1));
    }
    return out;
}

/// Velocity and heat of node i and those after it, as half floats.
template <class D>
HWY_INLINE void storeNodes(D d, const NodeRows& rows, int j, const Smoothing& y, const Smoothing& z, const float* u,
    std::size_t i, std::uint16_t* halves)
{
    const auto sum = [&](const LatestRows<2>& of)
                         HWY_ATTR { return hn::Load(d, of.at(j) + i) + hn::Load(d, of.at(j - 1) + i); };
    const auto v = acrossX(y, [&](int side) HWY_ATTR { return hn::Load(d, rows.y.at(j + side) + i); });
    const auto w = acrossX(z, [&](int side) HWY_ATTR { return 0.25F * sum(rows.z[side + 1]); });
    const auto heat = 0.125F * (sum(rows.heat[1]) + sum(rows.heat[0]));
    HWY_ALIGN float quads[4 * kAirLanes];
    hn::StoreInterleaved4(boundedSpeed(d, hn::Load(d, u + i)), boundedSpeed(d, v), boundedSpeed(d, w), heat, d, quads);
    for (std::size_t part = 0; part < 4 * hn::Lanes(d); part += hn::Lanes(d)) {
        storeHalf(hn::Load(d, quads + part), halves + 4 * i + part);
    }
}

void nodePlane(const AirCells& cells, AirField& field, int k)
{
    const AllFaces faces(cells, true, k);
    const glm::ivec3 n = cells.grid.cells;
    const auto last = static_cast<std::size_t>(n.x);
    const Smoothing z(k, n.z);
    const auto rowOf = [&](int j) { return cells.column.at(0, j, k); };
    NodeRows rows;
    HWY_ALIGN float room[kAirLanes + kRowRoom];
    float* mean = room + kAirLanes;
    HWY_ALIGN float u[kRowRoom];
    HWY_ALIGN std::uint16_t halves[4 * kRowRoom];
    findRows(cells, faces, rowOf(-1), -1, z.beside != 0.0F, rows);
    findMeans(cells, faces.y, rowOf(0), 0, rows);
    for (int j = 0; j <= n.y; ++j) {
        findRows(cells, faces, rowOf(j), j, z.beside != 0.0F, rows);
        meansAlongX(rows, j, last, mean);
        if (j < n.y) {
            findMeans(cells, faces.y, rowOf(j + 1), j + 1, rows);
        }
        smoothAlongX(last, mean, u);
        const Smoothing y(j, n.y);
        forNodes(last + 1, [&](auto d, std::size_t i) HWY_ATTR { storeNodes(d, rows, j, y, z, u, i, halves); });
        std::copy_n(halves, field.row,
            field.quads.data() + static_cast<std::size_t>(j) * field.row + static_cast<std::size_t>(k) * field.plane);
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
