#pragma once

#include <cstdint>

namespace fumage {

/// What a particle's random numbers are for; each purpose has a stream of its own, see streamBits(). Changing a value
/// changes every picture.
enum ParticleStream : std::uint32_t {
    kBirthAcross = 0,
    kBirthAlong = 1,
    kBirthBody = 2,
    kBirthVelocityX = 3,
    kBirthVelocityY = 4,
    kBirthVelocityZ = 5,
    kBirthConeAngle = 6,
    kBirthConeTurn = 7,
    kBirthDepth = 8,
    kBirthRim = 9,
    kBirthPixel = 10,
    kHeatStream = 20,
    kLifetimeStream = 21,
    kSizeStream = 22,
    kRotationStream = 30,
    kSpinStream = 31,
    kSliceStream = 32,
    kParentStream = 40, ///< and the seven after it: draws of the particle that it is born on
};

} // namespace fumage
