#include "core/effect/gradient.h"

#include <algorithm>
#include <cassert>

namespace fumage {

Gradient::Gradient(std::initializer_list<GradientStop> stops)
    : count(static_cast<int>(stops.size()))
{
    assert(stops.size() >= 1 && stops.size() <= storage.size());
    std::copy(stops.begin(), stops.end(), storage.begin());
}

glm::vec3 Gradient::at(float position) const
{
    const std::span<const GradientStop> all = stops();
    if (all.empty()) {
        return glm::vec3(1.0F);
    }
    if (position <= all.front().at) {
        return all.front().colour;
    }
    for (std::size_t i = 1; i < all.size(); ++i) {
        if (position < all[i].at) {
            const float t = (position - all[i - 1].at) / (all[i].at - all[i - 1].at);
            return all[i - 1].colour + (all[i].colour - all[i - 1].colour) * t;
        }
    }
    return all.back().colour;
}

} // namespace fumage
