#include "core/simulation/emitter.h"

#include "core/base/hash.h"
#include "core/base/math.h"

#include <cmath>

namespace fumage {

namespace {

enum BirthStream : std::uint32_t { kAcross = 0, kAlong = 1, kBody = 2, kVelocityX = 3, kVelocityY = 4, kVelocityZ = 5, kConeAngle = 6, kConeTurn = 7, kBetweenSteps = 8 };

float unit(std::uint32_t key, BirthStream stream)
{
    return unitFloat(streamBits(key, stream));
}

float signedUnit(std::uint32_t key, BirthStream stream)
{
    return signedFloat(streamBits(key, stream));
}

} // namespace

BirthPlace::BirthPlace(const Emitter& emitter, float dt)
    : m_emitter(emitter)
    , m_basis(planeBasis(emitter.normal))
    , m_spread(radians(emitter.spread))
    , m_dt(dt)
{
}

glm::vec3 BirthPlace::position(std::uint32_t key) const
{
    const float u = signedUnit(key, kAcross);
    const float v = signedUnit(key, kAlong);
    if (m_emitter.shape == EmitterShape::Rectangle) {
        return m_emitter.position + m_basis.across * (u * 0.5F * m_emitter.width) + m_basis.along * (v * 0.5F * m_emitter.depth);
    }
    const float angle = kPi * u;
    const float c = portableCos(angle);
    const float s = portableSin(angle);
    if (m_emitter.shape == EmitterShape::Disc) {
        const float r = m_emitter.radius * std::sqrt(unit(key, kBody));
        return m_emitter.position + m_basis.across * (r * c) + m_basis.along * (r * s);
    }
    // Uniform in a ball: height uniform on the sphere (Archimedes), radius by the cube root.
    const float level = std::sqrt(1.0F - v * v);
    const float r = m_emitter.radius * portablePow(unit(key, kBody), 1.0F / 3.0F);
    return m_emitter.position + m_basis.across * (r * level * c) + m_basis.along * (r * level * s) + m_emitter.normal * (r * v);
}

glm::vec3 BirthPlace::velocity(std::uint32_t key) const
{
    glm::vec3 n = m_emitter.normal;
    if (m_spread > 0.0F) {
        const float tilt = m_spread * std::sqrt(unit(key, kConeAngle));
        const float turn = kPi * signedUnit(key, kConeTurn);
        const float s = portableSin(tilt);
        n = n * portableCos(tilt) + m_basis.across * (s * portableCos(turn)) + m_basis.along * (s * portableSin(turn));
    }
    const float random = m_emitter.velocityRandomness;
    const float calm = 1.0F - random;
    return glm::vec3(n.x * (calm + random * signedUnit(key, kVelocityX)), n.y * (calm + random * unit(key, kVelocityY)),
               n.z * (calm + random * signedUnit(key, kVelocityZ)))
        * m_emitter.speed;
}

Birth BirthPlace::birth(std::uint32_t key) const
{
    Birth born{position(key), velocity(key)};
    if (m_emitter.subframe) {
        born.position += born.velocity * (m_dt * unit(key, kBetweenSteps));
    }
    return born;
}

} // namespace fumage
