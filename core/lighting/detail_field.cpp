#include "core/lighting/detail_field.h"

#include "core/base/hash.h"
#include "core/base/math.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace fumage {

namespace {

/// What parameters of 1 stand for: as much as fresh eyes liked.
constexpr float kStrength = 1.5F;
constexpr float kShadow = 1.5F;

glm::vec3 shiftOf(std::uint32_t seed, std::int64_t number)
{
    constexpr std::uint32_t kStream = 0xde7a11U;
    const std::uint32_t key = keyOf(seed ^ kStream, static_cast<std::uint64_t>(number));
    return {unitFloat(streamBits(key, 0)), unitFloat(streamBits(key, 1)), unitFloat(streamBits(key, 2))};
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

float PhaseBlend::operator()(float sum) const
{
    const float size = std::abs(sum);
    const float beyond = std::max(0.0F, size - flat);
    return std::copysign(size * gain - beyond * beyond * bend, sum);
}

DetailField::DetailField(const Effect& effect, const AdvectedCoordinates& coordinates)
    : phases(&coordinates.phases())
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

std::array<float, DetailTexture::kLevels> DetailField::octaveShares(const glm::mat3& slope, float metresPerPixel) const
{
    constexpr float kDrawnOut = 0.05F; // how soon an octave goes: the first by 1/e where |J|^2 has grown 17-fold
    constexpr float kMinPixelsAWave = 2.0F; // a wave; twice as many show all of it
    const float grown =
        (glm::dot(slope[0], slope[0]) + glm::dot(slope[1], slope[1]) + glm::dot(slope[2], slope[2])) / 3.0F;
    const float deformed = kDrawnOut * std::max(0.0F, grown - 1.0F);
    float pixelsAWave = wave / (std::sqrt(grown) * metresPerPixel);
    std::array<float, DetailTexture::kLevels> out{};
    float fineness = 1.0F;
    for (float& share : out) {
        const float shown = std::clamp(pixelsAWave / kMinPixelsAWave - 1.0F, 0.0F, 1.0F);
        share = portableExp(-deformed * fineness) * smoothStep(shown);
        fineness *= 4.0F;
        pixelsAWave *= 0.5F;
    }
    return out;
}

float DetailField::meanAt(const glm::vec3& place, float cell) const
{
    float sum = 0.0F;
    for (std::size_t i = 0; i < phases->size(); ++i) {
        const AdvectedPhase& phase = (*phases)[i];
        if (phase.weight < kMinPhaseWeight) {
            continue;
        }
        const AdvectedPlace from = advectedPlace(phase.map, place);
        const std::array<float, DetailTexture::kLevels> shares = octaveShares(from.slope, cell);
        const glm::vec3 at = from.place * tilesPerMetre + shift[i];
        for (std::size_t level = 0; level < shares.size(); ++level) {
            const float finer = level + 1 < shares.size() ? shares[level + 1] : 0.0F;
            if (const float share = shares[level] - finer; share > 0.0F) {
                sum += phase.weight * share * texture->at(static_cast<int>(level), at.x, at.y, at.z);
            }
        }
    }
    return PhaseBlend((*phases)[0].weight, (*phases)[1].weight)(sum);
}

} // namespace fumage
