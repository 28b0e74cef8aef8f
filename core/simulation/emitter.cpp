#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/simulation/emitter.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/hash-inl.h"
#include "core/base/math-inl.h"
#include "core/base/math.h"
#include "core/base/vector-inl.h"
#include "core/simulation/emitter.h"
#include "core/simulation/streams.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using DU = hn::RebindToUnsigned<D>;
using VU = hn::Vec<DU>;

/// Coordinates on a picture, -0.5 to 0.5 across and downwards: of pixels as likely as they are bright, and within them.
struct OnPicture {
    V across;
    V down;
};

HWY_INLINE OnPicture brightPlaces(D d, const Bitmap& picture, VU key, V u, V v)
{
    HWY_ALIGN std::uint32_t keys[HWY_MAX_BYTES / sizeof(std::uint32_t)];
    HWY_ALIGN float columns[HWY_MAX_BYTES / sizeof(float)];
    HWY_ALIGN float rows[HWY_MAX_BYTES / sizeof(float)];
    hn::Store(key, DU(), keys);
    const auto width = static_cast<std::size_t>(picture.width());
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
        const std::size_t pixel = picture.brightPixel(streamBits(keys[lane], kBirthPixel));
        columns[lane] = static_cast<float>(pixel % width);
        rows[lane] = static_cast<float>(pixel / width);
    }
    const auto share = [&](const float* pixels, V within, int count) HWY_ATTR {
        return (hn::Load(d, pixels) + 0.5F * within + 0.5F) / hn::Set(d, static_cast<float>(count)) - 0.5F;
    };
    return {share(columns, u, picture.width()), share(rows, v, picture.height())};
}

HWY_INLINE Vec3<V> birthPosition(D d, const Spawner& place, VU key)
{
    const Emitter& emitter = place.emitter;
    const V u = signedStream(d, key, kBirthAcross);
    const V v = signedStream(d, key, kBirthAlong);
    const auto onPlane = [&](V across, V along) HWY_ATTR {
        return broadcast(d, emitter.position) + across * place.basis.across + along * place.basis.along;
    };
    if (place.onPicture) {
        const OnPicture at = brightPlaces(d, emitter.picture, key, u, v);
        return onPlane(at.across * emitter.width, at.down * emitter.depth);
    }
    if (isRectangular(emitter)) {
        return onPlane(u * (0.5F * emitter.width), v * (0.5F * emitter.depth));
    }
    const SineCosine<V> turn = sinCos(d, u * kPi);
    const V body = unitStream(d, key, kBirthBody);
    if (emitter.shape == EmitterShape::Disc) {
        const V r = emitter.radius * hn::Sqrt(body);
        return onPlane(r * turn.cosine, r * turn.sine);
    }
    // Uniform in a ball: height uniform on the sphere (Archimedes), radius by the cube root.
    const V level = hn::Sqrt(hn::Max(hn::Zero(d), 1.0F - v * v));
    const V cubeRoot = exponential(d, logarithm(d, body) * (1.0F / 3.0F));
    const V r = emitter.radius * cubeRoot;
    return onPlane(r * (level * turn.cosine), r * (level * turn.sine)) + r * v * emitter.normal;
}

HWY_INLINE Vec3<V> birthVelocity(D d, const Spawner& place, VU key)
{
    const Emitter& emitter = place.emitter;
    Vec3<V> n = broadcast(d, emitter.normal);
    if (place.coneHeight > 0.0F) {
        // Equal heights of a sphere have equal areas (Archimedes).
        const V below = place.coneHeight * unitStream(d, key, kBirthConeAngle);
        const V sine = hn::Sqrt(below * (2.0F - below));
        const SineCosine<V> turn = sinCos(d, kPi * signedStream(d, key, kBirthConeTurn));
        n = n * (1.0F - below) + sine * turn.cosine * place.basis.across + sine * turn.sine * place.basis.along;
    }
    const Vec3<V> random{signedStream(d, key, kBirthVelocityX), unitStream(d, key, kBirthVelocityY),
        signedStream(d, key, kBirthVelocityZ)};
    return n * (random * emitter.velocityRandomness + glm::vec3(1.0F - emitter.velocityRandomness)) * emitter.speed;
}

/// A particle's start.
struct Start {
    Vec3<V> position;
    Vec3<V> velocity;
};

/// Takes starts at the emitter's place now to where it was when they were born. The turn from normal n to m, unit
/// vectors, is v + k x v + k x (k x v) / (1 + n.m) with k = n x m.
HWY_INLINE Start onTheWay(D d, const Spawner& place, VU key, const Start& born)
{
    const EmitterTravel& travel = place.travel;
    const V lived = travel.betweenSteps ? unitFloat(d, key) : hn::Zero(d);
    Vec3<V> away = born.position - place.emitter.position;
    Vec3<V> velocity = born.velocity;
    if (travel.normalBefore != place.emitter.normal) {
        const Vec3<V> normal = broadcast(d, place.emitter.normal);
        const Vec3<V> then = normal + lived * (travel.normalBefore - place.emitter.normal);
        const V perLength = 1.0F / hn::Sqrt(dot(then, then));
        const Vec3<V> k = cross(normal, then) * perLength;
        const V fold = 1.0F / (1.0F + dot(normal, then) * perLength);
        const auto turned = [&](const Vec3<V>& v) HWY_ATTR {
            const Vec3<V> aside = cross(k, v);
            return v + aside + cross(k, aside) * fold;
        };
        away = turned(away);
        velocity = turned(velocity);
    }
    return {away + place.emitter.position - lived * travel.way, velocity + travel.velocity};
}

void spawn(const Spawner& place, std::int64_t randomIndex, std::int32_t step, std::size_t slot, std::size_t count,
    Particles& particles)
{
    const D d;
    const DU du;
    const hn::RebindToSigned<D> di;
    const std::size_t lanes = hn::Lanes(d);
    // Neighbours of the last few may be another thread's: what does not fill a vector goes through memory of its own.
    const auto store = [lanes](auto tag, auto values, auto* to, std::size_t n) HWY_ATTR {
        if (n == lanes) {
            hn::StoreU(values, tag, to);
            return;
        }
        HWY_ALIGN hn::TFromD<decltype(tag)> buffer[HWY_MAX_BYTES / sizeof(float)];
        hn::Store(values, tag, buffer);
        std::copy_n(buffer, n, to);
    };
    for (std::size_t done = 0; done < count; done += lanes) {
        const auto index = static_cast<std::uint64_t>(randomIndex) + done;
        const auto start = static_cast<std::uint32_t>(index);
        const VU low = hn::Iota(du, 0U) + start;
        const VU carry = hn::VecFromMask(
            du, hn::Lt(low, hn::Set(du, start))); // all ones, which is -1, where the low half has wrapped
        const VU high = static_cast<std::uint32_t>(index >> 32U) - carry;
        const VU key = keysOf(place.emitter.seed, low, high);
        Start born{birthPosition(d, place, key), birthVelocity(d, place, key)};
        if (place.travels) {
            born = onTheWay(d, place, key, born);
        }
        const Vec3<V>& p = born.position;
        const Vec3<V>& v = born.velocity;
        const std::size_t n = std::min(lanes, count - done);
        const std::size_t to = slot + done;
        store(d, p.x, particles.x.data() + to, n);
        store(d, p.y, particles.y.data() + to, n);
        store(d, p.z, particles.z.data() + to, n);
        store(d, v.x, particles.vx.data() + to, n);
        store(d, v.y, particles.vy.data() + to, n);
        store(d, v.z, particles.vz.data() + to, n);
        store(du, key, particles.key.data() + to, n);
        store(di, hn::Set(di, step), particles.birthStep.data() + to, n);
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(spawn);

Spawner::Spawner(const Emitter& from)
    : emitter(from)
    , basis(planeBasis(from.normal))
    , onPicture(isOnPicture(from))
{
    const float half = portableSin(0.5F * radians(from.spread));
    coneHeight = 2.0F * half * half; // 1 - cos(spread), without its cancellation
}

Spawner::Spawner(const Emitter& at, const EmitterTravel& coming)
    : Spawner(at)
{
    travel = coming;
    travels = coming.way != glm::vec3(0.0F) || coming.normalBefore != at.normal || coming.velocity != glm::vec3(0.0F);
}

void spawnParticles(const Spawner& place, std::int64_t randomIndex, std::int32_t step, std::size_t slot,
    std::size_t count, Particles& particles)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(spawn);
    kernel(place, randomIndex, step, slot, count, particles);
}

} // namespace fumage
#endif
