#include "core/lighting/detail_field.h"

#include "core/base/random_place.h"

#include <algorithm>
#include <cmath>

namespace fumage {

namespace {

/// What parameters of 1 stand for: as much as fresh eyes liked.
constexpr float kStrength = 1.5F;
constexpr float kShadow = 1.5F;

glm::vec3 shiftOf(std::uint32_t seed, std::int64_t number)
{
    constexpr std::uint32_t kStream = 0xde7a11U;
    return randomInUnitCube(keyOf(seed ^ kStream, static_cast<std::uint64_t>(number)), 0);
}

} // namespace

bool hasDetail(const Effect& effect)
{
    return effect.look.detail > 0.0F && effect.air.enabled && effect.look.mask == MaskShape::Disc;
}

PhaseBlend::PhaseBlend(float one, float other)
{
    const float a = std::max(one, other);
    const float b = std::min(one, other);
    gain = 1.0F / a;
    if (b >= kMinPhaseWeight) {
        flat = a - b;
        bend = 1.0F / (4.0F * a * b);
    }
}

DetailField::DetailField(const Effect& effect, const AdvectedCoordinates& coordinates, PhaseMix phaseMix)
    : phases(&coordinates.phases())
    , mix(phaseMix)
    , wave(effect.look.detailSize)
    , tilesPerMetre(1.0F / (static_cast<float>(DetailTexture::kWaves) * effect.look.detailSize))
    , strength(kStrength * effect.look.detail)
    , edge(effect.look.detailEdge)
    , relief(effect.look.detailRelief)
    , shadow(kShadow * effect.look.detailShadow)
{
    for (std::size_t i = 0; i < shift.size(); ++i) {
        shift[i] = shiftOf(effect.noise.seed, (*phases)[i].seed);
    }
}

bool shadowsAlike(const DetailField& one, const DetailField& other)
{
    return one.phases == other.phases && one.mix == other.mix && one.shift == other.shift && one.wave == other.wave
        && one.shadow == other.shadow;
}

} // namespace fumage
