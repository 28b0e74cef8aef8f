#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/simulation/air_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/cache_control.h>
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

/// The columns that a step of particles in air changes.
struct Carried {
    Moving moving;
    Vec3<V> relative; ///< velocity against the air, m/s
    V heat;
    Shape shape; ///< where they deform

    static HWY_INLINE Carried from(D d, const Particles& p, std::size_t i)
    {
        Carried out{Moving::from<false>(d, p, i), load(d, p.relativeX, p.relativeY, p.relativeZ, i),
            hn::Load(d, p.heat.data() + i), Shape::round(d)};
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

/// The velocity after a touch of a surface: what goes into it turns round, with the restitution, and what goes along it
/// is slowed.
/// @param outward of the surface
HWY_INLINE Vec3<V> afterTouch(D d, const AirConstants& air, const Vec3<V>& velocity, const Vec3<V>& outward)
{
    const V into = hn::Min(hn::Zero(d), dot(velocity, outward));
    if (air.coupling == Coupling::Carried) {
        return velocity - outward * into;
    }
    const Vec3<V> along = velocity - outward * dot(velocity, outward);
    const auto isTouched = hn::Lt(into, hn::Zero(d));
    return chosen(isTouched, along * (1.0F - air.friction) - outward * (into * air.restitution), velocity);
}

/// The same of the obstacle at a place on it: what is not carried has a velocity of its own against one that moves.
HWY_INLINE Vec3<V> afterTouchOfObstacle(
    D d, const AirConstants& air, const Vec3<V>& place, const Vec3<V>& velocity, const Vec3<V>& outward)
{
    if (!air.obstacleMoves || air.coupling == Coupling::Carried) {
        return afterTouch(d, air, velocity, outward);
    }
    const Vec3<V> wall = (place - air.obstaclePosition) * air.obstacleGrowth + air.obstacleVelocity;
    return afterTouch(d, air, velocity - wall, outward) + wall;
}

/// Puts places that lie inside a ball onto it, and takes what is left of the velocity into it.
HWY_INLINE void keepOutOfBall(D d, const AirConstants& air, Vec3<V>& place, Vec3<V>& velocity)
{
    const float radius = air.obstacleHalf.x;
    const Vec3<V> away = place - air.obstaclePosition;
    const V distance2 = dot(away, away);
    const auto inside = hn::Lt(distance2, hn::Set(d, radius * radius));
    constexpr float kMin = 1e-12F; // m^2: the centre has no direction
    const Vec3<V> outward = away * hn::Div(hn::Set(d, 1.0F), hn::Sqrt(hn::Max(distance2, hn::Set(d, kMin))));
    Vec3<V> pushed = outward * radius + air.obstaclePosition;
    if (air.hasGround) {
        // Under the ground it would come out of the ball: beside the ball instead, at the height of the ground.
        const float below = air.groundHeight - air.obstaclePosition.y;
        const auto buried = hn::Lt(pushed.y, hn::Set(d, air.groundHeight));
        const V level = hn::Sqrt(hn::Max(away.x * away.x + away.z * away.z, hn::Set(d, kMin)));
        const V ring = hn::Div(hn::Sqrt(hn::Max(hn::Zero(d), hn::Set(d, radius * radius - below * below))), level);
        const Vec3<V> beside{air.obstaclePosition.x + ring * away.x, hn::Set(d, air.groundHeight),
            air.obstaclePosition.z + ring * away.z};
        pushed = chosen(buried, beside, pushed);
    }
    place = chosen(inside, pushed, place);
    velocity = chosen(inside, afterTouchOfObstacle(d, air, place, velocity, outward), velocity);
}

/// The same for a box: out through its nearest face, and not through one that lies under the ground.
HWY_INLINE void keepOutOfBox(D d, const AirConstants& air, Vec3<V>& place, Vec3<V>& velocity)
{
    const Vec3<V> away = place - air.obstaclePosition;
    const Vec3<V> half = broadcast(d, air.obstacleHalf);
    const Vec3<V> depth{half.x - hn::Abs(away.x), half.y - hn::Abs(away.y), half.z - hn::Abs(away.z)};
    const V zero = hn::Zero(d);
    const auto inside = hn::And(hn::And(hn::Gt(depth.x, zero), hn::Gt(depth.y, zero)), hn::Gt(depth.z, zero));
    const bool onGround = air.hasGround && air.obstaclePosition.y - air.obstacleHalf.y <= air.groundHeight;
    const V up = onGround ? hn::Set(d, 1.0F) : hn::CopySign(hn::Set(d, 1.0F), away.y);
    const V depthY = onGround ? half.y - away.y : depth.y;
    const auto byX = hn::And(hn::Le(depth.x, depthY), hn::Le(depth.x, depth.z));
    const auto byZ = hn::AndNot(byX, hn::Le(depth.z, depthY));
    const auto byY = hn::Not(hn::Or(byX, byZ));
    const auto throughX = hn::And(inside, byX);
    const auto throughY = hn::And(inside, byY);
    const auto throughZ = hn::And(inside, byZ);
    place.x = hn::IfThenElse(throughX, air.obstaclePosition.x + hn::CopySign(half.x, away.x), place.x);
    place.y = hn::IfThenElse(throughY, air.obstaclePosition.y + half.y * up, place.y);
    place.z = hn::IfThenElse(throughZ, air.obstaclePosition.z + hn::CopySign(half.z, away.z), place.z);
    if (air.coupling == Coupling::Carried) {
        velocity = {hn::IfThenZeroElse(throughX, velocity.x), hn::IfThenZeroElse(throughY, velocity.y),
            hn::IfThenZeroElse(throughZ, velocity.z)};
        return;
    }
    const V one = hn::Set(d, 1.0F);
    const Vec3<V> outward{hn::IfThenElseZero(throughX, hn::CopySign(one, away.x)), hn::IfThenElseZero(throughY, up),
        hn::IfThenElseZero(throughZ, hn::CopySign(one, away.z))};
    velocity =
        chosen(hn::Gt(dot(outward, outward), zero), afterTouchOfObstacle(d, air, place, velocity, outward), velocity);
}

/// Keeps places out of obstacle and ground. Smoke slides along: what velocity it has into it goes. What is not carried
/// bounces.
HWY_INLINE void keepOut(D d, const AirConstants& air, Vec3<V>& place, Vec3<V>& velocity)
{
    if (air.hasGround) {
        const V ground = hn::Set(d, air.groundHeight);
        const auto under = hn::Lt(place.y, ground);
        if (air.coupling == Coupling::Carried) {
            velocity.y = hn::IfThenElse(under, hn::Max(velocity.y, hn::Zero(d)), velocity.y);
        } else {
            const Vec3<V> upward{hn::Zero(d), hn::Set(d, 1.0F), hn::Zero(d)};
            velocity = chosen(under, afterTouch(d, air, velocity, upward), velocity);
        }
        place.y = hn::Max(place.y, ground);
    }
    if (air.obstacle == Obstacle::Sphere) {
        keepOutOfBall(d, air, place, velocity);
    } else if (air.obstacle == Obstacle::Box) {
        keepOutOfBox(d, air, place, velocity);
    }
}

/// A vector of particles on its way through a step, whose stages follow one another.
struct Way {
    VU key;
    Vec3<V> position;
    Vec3<V> relative; ///< velocity against the air, m/s
    Vec3<V> flown; ///< the same in the mean of the step
    LanePlaces<V> places; ///< at which the air is read next
    AirThere<V> here; ///< air where the step begins
    V gradient2; ///< square of its velocity's gradient, m/s a cell
    Vec3<V> detail; ///< the swirls below the grid: those of turbulence, times the strength that the air has here
};

HWY_INLINE void setOut(D d, const StepConstants& constants, Way& way)
{
    way.places = placesIn(d, *constants.air.field, way.position);
}

HWY_INLINE void readHere(const StepConstants& constants, Way& way)
{
    const AirThere<V> here = airAt<true>(*constants.air.field, constants.air.reach, way.places);
    way.gradient2 =
        dot(here.slope[0], here.slope[0]) + dot(here.slope[1], here.slope[1]) + dot(here.slope[2], here.slope[2]);
    way.here = here;
    if (constants.air.coupling == Coupling::Free) {
        const V nothing = hn::Zero(D());
        way.here.velocity = uniform(nothing);
        way.gradient2 = nothing;
    }
}

template <class Time>
HWY_INLINE void accelerate(D d, const StepConstants& constants, const Time& time, Way& way)
{
    if (constants.air.coupling != Coupling::Carried) {
        way.relative = way.relative - way.here.velocity; // it was its own
    }
    // The air carries what all heat does alike: only a particle's own share of it is left.
    const V lift = constants.buoyancy * heatDeviation(d, constants, way.key) * way.here.heat;
    const Vec3<V> before = way.relative;
    way.relative = accelerated(d, constants, time, way.key, lift, way.position, before);
    way.flown = flown(d, constants, time, before, way.relative);
    way.places =
        placesIn(d, *constants.air.field, way.position + (way.here.velocity + way.flown) * time(0.5F * constants.dt));
}

HWY_INLINE void findDetail(D d, const StepConstants& constants, Way& way)
{
    Vec3<V> detail = uniform(hn::Zero(d));
    Vec3<V> none = detail;
    if (constants.octaves > 0 && constants.air.coupling == Coupling::Carried) {
        addTurbulence<false>(d, constants, way.position, constants.air.detail * hn::Sqrt(way.gradient2), detail, none);
    }
    way.detail = detail;
}

/// How far the air turns what is in it during a step.
template <class Time>
HWY_INLINE Vec3<V> turnOf(const StepConstants& constants, const Time& time, const Vec3<V> (&slope)[3])
{
    const Vec3<V> curl{slope[1].z - slope[2].y, slope[2].x - slope[0].z, slope[0].y - slope[1].x};
    return curl * time(0.5F * constants.dt / constants.air.field->grid.cell);
}

template <class Time>
HWY_INLINE void arrive(D d, const StepConstants& constants, const Time& time, const Way& way, Vec3<V>& position,
    Vec3<V>& velocity, Vec3<V>& relative, V& heat)
{
    const AirThere<V> midway = airAt<false>(*constants.air.field, constants.air.reach, way.places);
    // What is not carried keeps the heat that it was born with; how soon it is seen to glow no longer is its look's.
    heat = constants.air.coupling == Coupling::Carried ? midway.heat : hn::Set(d, 1.0F);
    relative = way.relative;
    // Inertia is along a straight way: what is not carried has the air's push where the step began.
    const Vec3<V> air = constants.air.coupling == Coupling::Carried ? midway.velocity : way.here.velocity;
    velocity = air + relative;
    position = way.position + (air + way.flown + way.detail) * time(constants.dt);
    if (constants.rotation != 0.0F) {
        const SineCosine<V> angle = time.rotation(d, constants);
        position = turnedAboutPivot(angle, constants, position);
        velocity = rotated(angle, velocity);
        relative = rotated(angle, relative);
    }
    if (constants.air.coupling == Coupling::Carried) {
        keepOut(d, constants.air, position, relative);
        return;
    }
    keepOut(d, constants.air, position, velocity);
    relative = velocity; // the next step takes the air's from it
}

/// Vectors that go through a step together, stage by stage: what one of them waits for is then hidden behind the
/// others.
constexpr std::size_t kTogether = 4;
/// So many of them are fetched in advance: a particle has more columns than the processor can foresee.
constexpr std::size_t kAhead = 2;
static_assert(Particles::kChunk % (kTogether * hn::MaxLanes(D())) == 0);

void carryWhole(const StepConstants& constants, Particles& particles, std::size_t chunk)
{
    const D d;
    const WholeStep time;
    Particles& p = particles;
    const std::size_t end = (chunk + 1) * Particles::kChunk;
    Way ways[kTogether];
    for (std::size_t first = chunk * Particles::kChunk; first < end; first += kTogether * hn::Lanes(d)) {
        const auto each = [&](const auto& stage) HWY_ATTR {
            for (std::size_t n = 0; n < kTogether; ++n) {
                stage(ways[n], first + n * hn::Lanes(d));
            }
        };
        forEachColumn([&](const auto& column) {
            const auto& numbers = p.*column.member;
            for (std::size_t n = 0; !numbers.empty() && n < kTogether; ++n) {
                hwy::Prefetch(numbers.data() + first + (kAhead * kTogether + n) * hn::Lanes(d));
            }
        });
        each([&](Way& way, std::size_t i) HWY_ATTR {
            way.position = load(d, p.x, p.y, p.z, i);
            setOut(d, constants, way);
        });
        each([&](Way& way, std::size_t /*i*/) HWY_ATTR { readHere(constants, way); });
        each([&](Way& way, std::size_t i) HWY_ATTR {
            way.key = hn::Load(DU(), p.key.data() + i);
            way.relative = load(d, p.relativeX, p.relativeY, p.relativeZ, i);
            accelerate(d, constants, time, way);
        });
        each([&](Way& way, std::size_t /*i*/) HWY_ATTR { findDetail(d, constants, way); });
        if (p.rolls()) {
            each([&](Way& way, std::size_t i) HWY_ATTR {
                store(load(d, p.rollX, p.rollY, p.rollZ, i) + turnOf(constants, time, way.here.slope), p.rollX, p.rollY,
                    p.rollZ, i);
            });
        }
        if (p.deforms()) {
            each([&](Way& way, std::size_t i) HWY_ATTR {
                deformed(d, constants, time, way.here.slope, way.gradient2, Shape::from(d, p, i)).to(d, p, i);
            });
        }
        each([&](Way& way, std::size_t i) HWY_ATTR {
            Vec3<V> position, velocity, relative;
            V heat;
            arrive(d, constants, time, way, position, velocity, relative, heat);
            store(position, p.x, p.y, p.z, i);
            store(velocity, p.vx, p.vy, p.vz, i);
            store(relative, p.relativeX, p.relativeY, p.relativeZ, i);
            hn::Store(heat, d, p.heat.data() + i);
        });
    }
}

/// Where in the source a particle begins that was born on the emitter: nearer to the middle, so that none stands at the
/// rim, where the air does and would keep a skirt of smoke, and above the plane by a depth that ends as a dome. A slab
/// of even density would be seen as one. On a picture it stays where it is, nearer to the plane.
HWY_INLINE Vec3<V> positionInSource(D d, const AirConstants& air, VU key, const Vec3<V>& born, const Vec3<V>& pivot)
{
    constexpr float kReach = 0.8F; // of the source's own
    constexpr float kInwards = 0.85F; // of that, at most
    constexpr float kDepthOfPicture = 0.25F; // of the source's
    const bool onPicture = air.bornOnPicture;
    const V reach = onPicture ? hn::Set(d, 1.0F) : kReach - kReach * kInwards * unitStream(d, key, kBirthRim);
    const Vec3<V> away = (born - pivot) * reach;
    const V across = dot(away, air.sourceSides[0]);
    const V along = dot(away, air.sourceSides[1]);
    const V dome = hn::Max(1.0F - across * across - along * along, hn::Zero(d));
    const glm::vec3 depth = (onPicture ? kDepthOfPicture : 1.0F) * air.sourceDepth;
    return away + (unitStream(d, key, kBirthDepth) * dome) * depth + pivot;
}

/// What a particle becomes between its birth and the end of the step, of which it has lived a share.
/// @param travel of the emitter in the step, m @param born with the velocity that the emitter gives it
HWY_INLINE Carried throughParts(
    D d, std::span<const StepConstants> parts, const glm::vec3& travel, VU key, V share, const Carried& born)
{
    const StepConstants& whole = parts.front();
    Carried at = born;
    if (!whole.air.bornOnParent) {
        at.moving.position =
            positionInSource(d, whole.air, key, born.moving.position, broadcast(d, whole.pivot) - share * travel);
    }
    // The air of the source has the emitter's velocity; what a particle has of its own is the rest.
    at.relative = whole.air.coupling == Coupling::Carried ? born.moving.velocity - whole.air.sourceVelocity
                                                          : born.moving.velocity;
    at.shape = Shape::round(d);
    for (const StepConstants& constants : parts) {
        const PartOfStep time{clamp01(d, (share - hn::Set(d, constants.rest)) / hn::Set(d, constants.share))};
        Way way;
        way.key = key;
        way.position = at.moving.position;
        way.relative = at.relative;
        setOut(d, constants, way);
        readHere(constants, way);
        accelerate(d, constants, time, way);
        findDetail(d, constants, way);
        at.moving.roll = at.moving.roll + turnOf(constants, time, way.here.slope);
        at.shape = deformed(d, constants, time, way.here.slope, way.gradient2, at.shape);
        arrive(d, constants, time, way, at.moving.position, at.moving.velocity, at.relative, at.heat);
    }
    return at;
}

/// Slots [first, last); neighbours in the same vectors stay as they are.
void carryJustBorn(std::span<const StepConstants> parts, const glm::vec3& way, Particles& particles, std::size_t first,
    std::size_t last)
{
    const D d;
    for (std::size_t i = first / hn::Lanes(d) * hn::Lanes(d); i < last; i += hn::Lanes(d)) {
        const VU key = hn::Load(DU(), particles.key.data() + i);
        const V lived = agesInSteps(d, particles, i, key, parts.front().step, parts.front().betweenSteps);
        const Carried before = Carried::from(d, particles, i);
        const Carried after = throughParts(d, parts, way, key, lived, before);
        const auto isNew = hn::AndNot(hn::FirstN(d, first - std::min(first, i)), hn::FirstN(d, last - i));
        Carried kept;
        kept.moving.position = chosen(isNew, after.moving.position, before.moving.position);
        kept.moving.velocity = chosen(isNew, after.moving.velocity, before.moving.velocity);
        kept.moving.roll = chosen(isNew, after.moving.roll, before.moving.roll);
        kept.relative = chosen(isNew, after.relative, before.relative);
        kept.heat = hn::IfThenElse(isNew, after.heat, before.heat);
        kept.shape = chosen(isNew, after.shape, before.shape);
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
    HWY_DYNAMIC_DISPATCH(carryWhole)(constants, particles, chunk);
}

void carryNewParticles(std::span<const StepConstants> parts, const glm::vec3& way, Particles& particles,
    std::size_t first, std::size_t last)
{
    HWY_DYNAMIC_DISPATCH(carryJustBorn)(parts, way, particles, first, last);
}

} // namespace fumage
#endif
