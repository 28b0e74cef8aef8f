#include "core/export/glow_ramp.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/vec4.hpp>

namespace fumage {

namespace {

constexpr float kSteps = kGlowKeys - 1;

/// Sums of hues, and of their weights, by key.
using KeySums = std::array<glm::dvec4, kGlowKeys>;

float brightest(const glm::vec3& colour)
{
    return std::max({colour.r, colour.g, colour.b});
}

KeySums sumsOfRow(const Image& emission, int y, float scale)
{
    KeySums sums{};
    const float* pixel = emission.row(y);
    for (int x = 0; x < emission.width; ++x, pixel += 4) {
        const glm::vec3 colour(pixel[0], pixel[1], pixel[2]);
        const float most = brightest(colour);
        if (!(most > 0.0F) || !(pixel[3] > 0.0F)) {
            continue;
        }
        const float place = glowPosition(most / scale) * kSteps;
        const int key = std::min(static_cast<int>(place), kGlowKeys - 2);
        const float share = place - static_cast<float>(key);
        const glm::dvec4 hue(glm::dvec3(colour / most), 1.0);
        sums[static_cast<std::size_t>(key)] += hue * static_cast<double>((1.0F - share) * pixel[3]);
        sums[static_cast<std::size_t>(key) + 1] += hue * static_cast<double>(share * pixel[3]);
    }
    return sums;
}

/// Keys that no pixel is near have the hue of their neighbour, the dimmer one first.
void fillGaps(KeySums& sums)
{
    for (std::size_t k = 1; k < sums.size(); ++k) {
        sums[k] = sums[k].w > 0.0 ? sums[k] : sums[k - 1];
    }
    for (std::size_t k = sums.size() - 1; k-- > 0;) {
        sums[k] = sums[k].w > 0.0 ? sums[k] : sums[k + 1];
    }
}

} // namespace

float glowPosition(float brightness)
{
    const float clamped = std::clamp(brightness, 0.0F, 1.0F);
    const auto key = static_cast<float>(std::min(static_cast<int>(std::sqrt(clamped) * kSteps), kGlowKeys - 2));
    const float above = clamped * (kSteps * kSteps) - key * key;
    return std::clamp((key + above / (2.0F * key + 1.0F)) / kSteps, 0.0F, 1.0F);
}

float glowBrightness(float position)
{
    const float place = std::clamp(position, 0.0F, 1.0F) * kSteps;
    const auto key = static_cast<float>(std::min(static_cast<int>(place), kGlowKeys - 2));
    return (key * key + (place - key) * (2.0F * key + 1.0F)) / (kSteps * kSteps);
}

glm::vec3 glowColour(const GlowRamp& ramp, float position)
{
    const float place = std::clamp(position, 0.0F, 1.0F) * kSteps;
    const int key = std::min(static_cast<int>(place), kGlowKeys - 2);
    const float share = place - static_cast<float>(key);
    const glm::vec3& low = ramp.colours[static_cast<std::size_t>(key)];
    return low + (ramp.colours[static_cast<std::size_t>(key) + 1] - low) * share;
}

GlowRamp fitGlowRamp(const Image& emission, float scale)
{
    GlowRamp ramp;
    if (!(scale > 0.0F)) {
        return ramp;
    }
    std::vector<KeySums> rows(static_cast<std::size_t>(emission.height));
    parallelFor(rows.size(), [&](std::size_t y) { rows[y] = sumsOfRow(emission, static_cast<int>(y), scale); });
    KeySums sums{};
    for (const KeySums& row : rows) { // in one order for any number of threads
        for (std::size_t k = 0; k < sums.size(); ++k) {
            sums[k] += row[k];
        }
    }
    fillGaps(sums);
    for (int k = 1; k < kGlowKeys; ++k) {
        const glm::vec3 hue(sums[static_cast<std::size_t>(k)]);
        const float most = brightest(hue);
        const float position = glowKeyPosition(k);
        ramp.colours[static_cast<std::size_t>(k)] = most > 0.0F ? hue / most * (position * position) : glm::vec3(0.0F);
    }
    return ramp;
}

} // namespace fumage
