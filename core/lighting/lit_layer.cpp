#include "core/lighting/lit_layer.h"

#include <glm/common.hpp>

namespace fumage {

LitBounds::LitBounds(LitLayers layers)
{
    for (const LitLayer& layer : layers) {
        const Appearance& appearance = *layer.appearance;
        if (appearance.count == 0) {
            continue;
        }
        low = count == 0 ? appearance.low : glm::min(low, appearance.low);
        high = count == 0 ? appearance.high : glm::max(high, appearance.high);
        count += appearance.count;
        if (appearance.cover.mean * appearance.largestMass > cover * largestMass) {
            largestMass = appearance.largestMass;
            cover = appearance.cover.mean;
        }
    }
}

} // namespace fumage
