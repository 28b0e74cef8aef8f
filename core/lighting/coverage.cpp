#include "core/lighting/coverage.h"

#include "core/base/math.h"
#include "core/lighting/sprite_mask.h"

#include <algorithm>

namespace fumage {

float GreyCounts::kept(float threshold, float softness) const
{
    double sum = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < kGreys; ++i) {
        const float grey = static_cast<float>(i) / static_cast<float>(kGreys - 1);
        const double share = std::clamp((grey - threshold) / softness, 0.0F, 1.0F);
        sum += share * counts[i];
        all += counts[i];
    }
    return all > 0.0 ? static_cast<float>(sum / all) : 1.0F;
}

float maskMean(const Look& look)
{
    if (look.mask != MaskShape::Disc) {
        return 4.0F / kPi * (showsPicture(look) ? look.picture.opacity() : 1.0F);
    }
    const float softness = 1.0F / maskHardness(look);
    constexpr float kLost = 1.0F - Coverage::kSoftDisc; // of a disc by a profile that falls off all the way
    return softness < 1.0F ? 1.0F - kLost * softness : Coverage::kSoftDisc;
}

float textureLeaves(const Look& look, const GreyCounts& greys, float threshold)
{
    return look.texture > 0.0F && !showsPicture(look)
        ? 1.0F - look.texture + look.texture * greys.kept(threshold, look.erosionSoftness)
        : 1.0F;
}

Coverage coverageOf(const Look& look, const GreyCounts& greys)
{
    constexpr float kCorner = 1.41421356F; // of a square, in half edges
    Coverage cover;
    const float textured = textureLeaves(look, greys, 0.0F);
    constexpr float kMin = 1e-6F; // what covers nothing has no neighbours either
    cover.mean = std::max(kMin, maskMean(look) * textured);
    cover.reach = look.mask == MaskShape::Disc ? 1.0F : kCorner;
    cover.erodes = look.texture > 0.0F && !showsPicture(look) && look.erosion > 0.0F && textured > 0.0F;
    for (int i = 0; cover.erodes && i <= Coverage::kLives; ++i) {
        const float life = static_cast<float>(i) / static_cast<float>(Coverage::kLives);
        cover.left[static_cast<std::size_t>(i)] = textureLeaves(look, greys, look.erosion * life) / textured;
    }
    return cover;
}

} // namespace fumage
