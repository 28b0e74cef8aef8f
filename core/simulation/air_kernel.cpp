#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/simulation/air_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/flow/field-inl.h"
#include "core/simulation/air_kernel.h"
#include "core/simulation/moving-inl.h"
#include "core/simulation/shape-inl.h"
#include "core/simulation/swirls-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using namespace stepping;

/// What only particles in air have.
struct Carried {
    Moving moving;
    Vec3<V> relative; ///< velocity against the air, m/s
    V heat;
    Shape shape; ///< where they deform

    static HWY_INLINE Carried from(D d, const Particles& p, std::size_t i)
    {
        Carried out{Moving::from<false>(d, p, i), load(d, p.relativeX, p.relativeY, p.relativeZ, i), hn::Load(d, p.heat.data() + i), Shape::round(d)};
        if (p.deforms()) {
            out.shape = Shape::from(d, p, i);
        }
        if (p.rolls()) {
            out.moving.roll = load(d, p.rollX, p.rollY, p.rollZ, i);
        }
        return out;
    }

    HWY_INLINE void to(D d, Particles& p, std::size_t i) const
    {
        moving.to<false>(p, i);
        store(relative, p.relativeX, p.relativeY, p.relativeZ, i);
        hn::Store(heat, d, p.heat.data() + i);
        if (p.deforms()) {
            shape.to(d, p, i);
        }
        if (p.rolls()) {
            store(moving.roll, p.rollX, p.rollY, p.rollZ, i);
        }
    }
};

/// Puts places that lie inside a ball onto it, and takes what is left of the velocity into it.
HWY_INLINE void keepOutOfBall(D d, const AirConstants& air, Vec3<V>& place, Vec3<V>& velocity)
{
    const float radius = air.obstacleHalf.x;
    const Vec3<V> away = place - air.obstaclePlace;
    const V distance2 = dot(away, away);
    const auto inside = hn::Lt(distance2, hn::Set(d, radius * radius));
    constexpr float kLeast = 1e-12F; // m^2: the centre has no direction
    const Vec3<V> outward = away * hn::Div(hn::Set(d, 1.0F), hn::Sqrt(hn::Max(distance2, hn::Set(d, kLeast))));
    Vec3<V> pushed = outward * radius + air.obstaclePlace;
    if (air.hasGround) {
        // Under the ground it would come out of the ball: beside the ball instead, at the height of the ground.
        const float below = air.groundHeight - air.obstaclePlace.y;
        const auto buried = hn::Lt(pushed.y, hn::Set(d, air.groundHeight));
        const V level = hn::Sqrt(hn::Max(away.x * away.x + away.z * away.z, hn::Set(d, kLeast)));
        const V ring = hn::Div(hn::Sqrt(hn::Max(hn::Zero(d), hn::Set(d, radius * radius - below * below))), level);
        const Vec3<V> beside{air.obstaclePlace.x + ring * away.x, hn::Set(d, air.groundHeight), air.obstaclePlace.z + ring * away.z};
        pushed = chosen(buried, beside, pushed);
    }
    const V into = hn::Min(hn::Zero(d), dot(velocity, outward));
    place = chosen(inside, pushed, place);
    velocity = chosen(inside, velocity - outward * into, velocity);
}

/// The same for a box: out through its nearest face, and not through one that lies under the ground.
HWY_INLINE void keepOutOfBox(D d, const AirConstants& air, Vec3<V>& place, Vec3<V>& velocity)
{
    const Vec3<V> away = place - air.obstaclePlace;
    const Vec3<V> half = broadcast(d, air.obstacleHalf);
    const Vec3<V> depth{half.x - hn::Abs(away.x), half.y - hn::Abs(away.y), half.z - hn::Abs(away.z)};
    const V zero = hn::Zero(d);
    const auto inside = hn::And(hn::And(hn::Gt(depth.x, zero), hn::Gt(depth.y, zero)), hn::Gt(depth.z, zero));
    const bool onGround = air.hasGround && air.obstaclePlace.y - air.obstacleHalf.y <= air.groundHeight;
    const V up = onGround ? hn::Set(d, 1.0F) : hn::CopySign(hn::Set(d, 1.0F), away.y);
    const V depthY = onGround ? half.y - away.y : depth.y;
    const auto byX = hn::And(hn::Le(depth.x, depthY), hn::Le(depth.x, depth.z));
    const auto byZ = hn::AndNot(byX, hn::Le(depth.z, depthY));
    const auto byY = hn::Not(hn::Or(byX, byZ));
    const auto throughX = hn::And(inside, byX);
    const auto throughY = hn::And(inside, byY);
    const auto throughZ = hn::And(inside, byZ);
    place.x = hn::IfThenElse(throughX, air.obstaclePlace.x + hn::CopySign(half.x, away.x), place.x);
    place.y = hn::IfThenElse(throughY, air.obstaclePlace.y + half.y * up, place.y);
    place.z = hn::IfThenElse(throughZ, air.obstaclePlace.z + hn::CopySign(half.z, away.z), place.z);
    velocity = {hn::IfThenZeroElse(throughX, velocity.x), hn::IfThenZeroElse(throughY, velocity.y), hn::IfThenZeroElse(throughZ, velocity.z)};
}

/// Keeps places out of obstacle and ground. They slide along: what velocity they have into it goes.
HWY_INLINE void keepOut(D d, const AirConstants& air, Vec3<V>& place, Vec3<V>& velocity)
{
    if (air.hasGround) {
        const V ground = hn::Set(d, air.groundHeight);
        const auto under = hn::Lt(place.y, ground);
        velocity.y = hn::IfThenElse(under, hn::Max(velocity.y, hn::Zero(d)), velocity.y);
        place.y = hn::Max(place.y, ground);
    }
    if (air.obstacle == Obstacle::Sphere) {
        keepOutOfBall(d, air, place, velocity);
    } else if (air.obstacle == Obstacle::Box) {
        keepOutOfBox(d, air, place, velocity);
    }
}

/// Adds the swirls below the grid: those of turbulence, times the strength that the air has here.
HWY_INLINE void addDetail(D d, const StepConstants& constants, const AirThere<V>& air, const Vec3<V>& place, Vec3<V>& velocity)
{
    const V gradient2 = dot(air.slope[0], air.slope[0]) + dot(air.slope[1], air.slope[1]) + dot(air.slope[2], air.slope[2]);
    Vec3<V> none = uniform(hn::Zero(d));
    addTurbulence<false>(d, constants, place, constants.air.detail * hn::Sqrt(gradient2), velocity, none);
}

template <class Time>
HWY_INLINE Carried carried(D d, const StepConstants& constants, const Time& time, VU key, bool deforms, Carried at)
{
    const AirConstants& air = constants.air;
    Vec3<V>& p = at.moving.position;
    if (constants.vortexStrength != 0.0F) {
        p = turnedByVortex(d, constants, time, p);
    }
    const AirThere<V> here = airAt<true>(d, *air.field, air.reach, p);
    // The air carries what all heat does alike: only a particle's own share of it is left.
    const V lift = constants.buoyancy * heatDeviation(d, constants, key) * here.heat;
    at.relative = accelerated(d, constants, time, key, lift, p, at.relative);
    const AirThere<V> midway = airAt<false>(d, *air.field, air.reach, p + (here.velocity + at.relative) * time(0.5F * constants.dt));
    at.moving.velocity = midway.velocity + at.relative;
    at.heat = midway.heat;
    Vec3<V> velocity = at.moving.velocity;
    if (constants.octaves > 0) {
        addDetail(d, constants, here, p, velocity);
    }
    const Vec3<V> curl{here.slope[1].z - here.slope[2].y, here.slope[2].x - here.slope[0].z, here.slope[0].y - here.slope[1].x};
    at.moving.roll = at.moving.roll + curl * time(0.5F * constants.dt / air.field->grid.cell);
    p = p + velocity * time(constants.dt);
    if (deforms) {
        at.shape = deformed(d, constants, time, here.slope, at.shape);
    }
    if (constants.rotation != 0.0F) {
        const SineCosine<V> angle = time.rotation(d, constants);
        p = turnedAboutPivot(angle, constants, p);
        at.moving.velocity = rotated(angle, at.moving.velocity);
        at.relative = rotated(angle, at.relative);
    }
    keepOut(d, air, p, at.relative);
    return at;
}

void carryWhole(const StepConstants& constants, Particles& particles, std::size_t chunk)
{
    const D d;
    const std::size_t begin = chunk * Particles::kChunk;
    for (std::size_t i = begin; i < begin + Particles::kChunk; i += hn::Lanes(d)) {
        const VU key = hn::Load(DU(), particles.key.data() + i);
        carried(d, constants, WholeStep(), key, particles.deforms(), Carried::from(d, particles, i)).to(d, particles, i);
    }
}

/// Where in the source a particle begins that was born on the emitter: nearer to the middle, so that the rim is thin as that of its heat, and
/// above the plane by a depth that ends as a dome. A slab of even density would be seen as one: its rim stands still beside the stream.
HWY_INLINE Vec3<V> insideSource(D d, const StepConstants& constants, VU key, const Vec3<V>& onEmitter)
{
    constexpr float kRim = 0.5F; // of the reach
    const Vec3<V> away = (onEmitter - constants.pivot) * (1.0F - kRim * unitStream(d, key, kBirthRim));
    const V across = dot(away, constants.air.sourceSides[0]);
    const V along = dot(away, constants.air.sourceSides[1]);
    const V dome = hn::Max(1.0F - across * across - along * along, hn::Zero(d));
    return away + (unitStream(d, key, kBirthDepth) * dome) * constants.air.sourceDepth + constants.pivot;
}

/// Slots [first, last); neighbours in the same vectors stay as they are.
void carryJustBorn(const StepConstants& constants, Particles& particles, std::size_t first, std::size_t last)
{
    const D d;
    for (std::size_t i = first / hn::Lanes(d) * hn::Lanes(d); i < last; i += hn::Lanes(d)) {
        const VU key = hn::Load(DU(), particles.key.data() + i);
        const V share = agesInSteps(d, particles, i, key, constants.step, constants.betweenSteps);
        const Carried before = Carried::from(d, particles, i);
        Carried born = before;
        born.moving.position = insideSource(d, constants, key, born.moving.position);
        // The air of the source has the emitter's velocity; what a particle has of its own is the rest.
        born.relative = before.moving.velocity - constants.air.sourceVelocity;
        born.shape = Shape::round(d);
        const Carried after = carried(d, constants, PartOfStep{share}, key, particles.deforms(), born);
        const auto isNewborn = hn::AndNot(hn::FirstN(d, first - std::min(first, i)), hn::FirstN(d, last - i));
        Carried kept;
        kept.moving.position = chosen(isNewborn, after.moving.position, before.moving.position);
        kept.moving.velocity = chosen(isNewborn, after.moving.velocity, before.moving.velocity);
        kept.moving.roll = chosen(isNewborn, after.moving.roll, before.moving.roll);
        kept.relative = chosen(isNewborn, after.relative, before.relative);
        kept.heat = hn::IfThenElse(isNewborn, after.heat, before.heat);
        kept.shape = chosen(isNewborn, after.shape, before.shape);
        kept.to(d, particles, i);
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(carryWhole);
HWY_EXPORT(carryJustBorn);

void carryChunk(const StepConstants& constants, Particles& particles, std::size_t chunk)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(carryWhole);
    kernel(constants, particles, chunk);
}

void carryNewborns(const StepConstants& constants, Particles& particles, std::size_t first, std::size_t last)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(carryJustBorn);
    kernel(constants, particles, first, last);
}

} // namespace fumage
#endif
