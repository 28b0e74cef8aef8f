#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/rendering/pass_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/math-inl.h"
#include "core/lighting/grid_cell-inl.h"
#include "core/lighting/light_lookup-inl.h"
#include "core/rendering/pass_kernel.h"
#include "core/rendering/sprite_job.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

/// Cells around the particles of a block.
struct CellBlock {
    HWY_ALIGN std::int32_t corner[kSpriteBlock];
    HWY_ALIGN float fu[kSpriteBlock], fv[kSpriteBlock], fw[kSpriteBlock];

    CellBlock(const Particles& particles, const GridShape& shape, std::size_t begin)
    {
        const D d;
        for (std::size_t i = 0; i < kSpriteBlock; i += hn::Lanes(d)) {
            const GridCell<D> cell = gridCellAt(d, shape, load(d, particles.x, particles.y, particles.z, begin + i));
            hn::Store(cell.corner, hn::RebindToSigned<D>(), corner + i);
            store(cell.fraction, fu, fv, fw, i);
        }
    }
    [[nodiscard]] HWY_INLINE Float4 light(const GridShape& shape, const float* cells, std::size_t i) const
    {
        return trilinear<Float4>(shape, cells, corner[i], fu[i], fv[i], fw[i]);
    }
};

HWY_INLINE void put(SpriteTarget& target, std::size_t sprite, Float4 colours)
{
    std::memcpy(target.colours.data() + sprite * SpriteTarget::kStride, &colours, sizeof(colours));
}

void lightSixWaysOf(const PassJob& job, std::size_t begin)
{
    const GridShape& shape = job.sixWay->grid.shape;
    const CellBlock cells(*job.particles, shape, begin);
    for (std::size_t i = 0; i < kSpriteBlock; ++i) {
        if (job.batch->depth[begin + i] != SpriteBatch::kHidden) {
            put(*job.above, begin + i, cells.light(shape, job.sixWay->fromAbove.data(), i));
            put(*job.below, begin + i, cells.light(shape, job.sixWay->fromBelow.data(), i));
        }
    }
}

void shadowsOf(const PassJob& job, std::size_t begin)
{
    const D d;
    const GridShape& shape = job.light->shape;
    const CellBlock cells(*job.particles, shape, begin);
    HWY_ALIGN float depths[kSpriteBlock];
    for (std::size_t i = 0; i < kSpriteBlock; ++i) {
        depths[i] = job.batch->depth[begin + i] == SpriteBatch::kHidden
            ? 0.0F
            : cells.light(shape, job.light->light.data(), i)[3];
    }
    for (std::size_t i = 0; i < kSpriteBlock; i += hn::Lanes(d)) {
        hn::Store(exponential(d, hn::Load(d, depths + i) * -1.0F), d, depths + i);
    }
    for (std::size_t i = 0; i < kSpriteBlock; ++i) {
        job.inner->colours[(begin + i) * SpriteTarget::kStride + 1] = depths[i];
    }
}

/// A place in the picture as a share of it, x to the right and y up from the middle, and the depth in m.
HWY_INLINE Vec3<V> seen(D d, const View& view, const Vec3<V>& place)
{
    const Vec3<V> way = place - view.eye;
    const V depth = dot(way, view.forward);
    const V perMetre = view.focal / hn::Max(depth, hn::Set(d, kNear));
    return {dot(way, view.right) * perMetre * (1.0F / static_cast<float>(view.width)),
        dot(way, view.up) * perMetre * (1.0F / static_cast<float>(view.height)), depth};
}

/// Where the particles are at another moment, and which of them are there at all.
HWY_INLINE M seenAt(D d, const PassJob& job, const OtherMoment& moment, std::size_t at, Vec3<V>& place)
{
    const hn::RebindToSigned<D> di;
    const hn::RebindToUnsigned<D> du;
    const auto births = hn::Load(di, job.particles->birthStep.data() + at) + hn::Set(di, moment.laps);
    const auto born = hn::Eq(births, hn::Load(di, moment.particles->birthStep.data() + at));
    const auto same =
        hn::Eq(hn::Load(du, job.particles->key.data() + at), hn::Load(du, moment.particles->key.data() + at));
    place = seen(d, moment.view, load(d, moment.particles->x, moment.particles->y, moment.particles->z, at));
    const M both = hn::And(hn::RebindMask(d, born), hn::RebindMask(d, same));
    return hn::And(both, hn::Gt(place.z, hn::Set(d, kNear)));
}

/// The way from the moment before to the one after, halved; from or to now where one is missing; by its velocity where
/// it is nowhere else.
void motionOf(const PassJob& job, std::size_t begin)
{
    const D d;
    const Particles& particles = *job.particles;
    for (std::size_t i = 0; i < kSpriteBlock; i += hn::Lanes(d)) {
        const std::size_t at = begin + i;
        const Vec3<V> position = load(d, particles.x, particles.y, particles.z, at);
        const Vec3<V> now = seen(d, job.view, position);
        const Vec3<V> velocity = load(d, particles.vx, particles.vy, particles.vz, at);
        const Vec3<V> guess = seen(d, job.view, position + velocity * hn::Set(d, job.seconds)) - now;
        V x = guess.x;
        V y = guess.y;
        const auto prefer = [&](M where, const Vec3<V>& from, const Vec3<V>& to, float share) HWY_ATTR {
            x = hn::IfThenElse(where, (to.x - from.x) * share, x);
            y = hn::IfThenElse(where, (to.y - from.y) * share, y);
        };
        Vec3<V> before = now;
        Vec3<V> after = now;
        M hasBefore = hn::FirstN(d, 0); // none
        M hasAfter = hasBefore;
        if (job.previous.particles != nullptr) {
            hasBefore = seenAt(d, job, job.previous, at, before);
            prefer(hasBefore, before, now, 1.0F);
        }
        if (job.next.particles != nullptr) {
            hasAfter = seenAt(d, job, job.next, at, after);
            prefer(hasAfter, now, after, 1.0F);
        }
        prefer(hn::And(hasBefore, hasAfter), before, after, 0.5F);
        hn::StoreInterleaved4(x, y, now.z, hn::Zero(d), d, job.motion->colours.data() + at * SpriteTarget::kStride);
    }
}

void passBlock(const PassJob& job, std::size_t begin)
{
    if (job.above != nullptr) {
        lightSixWaysOf(job, begin);
    }
    if (job.motion != nullptr) {
        motionOf(job, begin);
    }
    if (job.inner != nullptr) {
        shadowsOf(job, begin);
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(passBlock);

void makePassBlock(const PassJob& job, std::size_t begin)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(passBlock);
    kernel(job, begin);
}

} // namespace fumage
#endif
