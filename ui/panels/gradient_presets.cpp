#include "ui/panels/gradient_presets.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QColor>
#include <QCoreApplication>

namespace fumage::ui {

namespace {

/// Linear RGB, from what is young or hottest to what is old or coolest in the order that the bar shows.
const std::array kPresets{
    GradientPreset{QT_TRANSLATE_NOOP("GradientPresets", "Fire"),
        {{0.0F, {0.25F, 0.01F, 0.0F}}, {0.4F, {1.0F, 0.12F, 0.01F}}, {0.75F, {1.0F, 0.45F, 0.08F}},
            {1.0F, {1.0F, 0.9F, 0.6F}}}},
    GradientPreset{QT_TRANSLATE_NOOP("GradientPresets", "Gas flame"),
        {{0.0F, {0.0F, 0.02F, 0.25F}}, {0.5F, {0.03F, 0.25F, 1.0F}}, {1.0F, {0.7F, 0.9F, 1.0F}}}},
    GradientPreset{QT_TRANSLATE_NOOP("GradientPresets", "Ice"),
        {{0.0F, {0.03F, 0.18F, 0.4F}}, {0.5F, {0.25F, 0.65F, 0.9F}}, {1.0F, {0.9F, 0.98F, 1.0F}}}},
    GradientPreset{QT_TRANSLATE_NOOP("GradientPresets", "Magic"),
        {{0.0F, {0.08F, 0.0F, 0.3F}}, {0.45F, {0.55F, 0.05F, 0.9F}}, {0.8F, {1.0F, 0.3F, 0.8F}},
            {1.0F, {1.0F, 0.85F, 1.0F}}}},
    GradientPreset{QT_TRANSLATE_NOOP("GradientPresets", "Poison"),
        {{0.0F, {0.01F, 0.06F, 0.0F}}, {0.5F, {0.12F, 0.6F, 0.03F}}, {1.0F, {0.75F, 1.0F, 0.25F}}}},
    GradientPreset{QT_TRANSLATE_NOOP("GradientPresets", "Sunset"),
        {{0.0F, {0.05F, 0.02F, 0.15F}}, {0.4F, {0.5F, 0.08F, 0.2F}}, {0.75F, {1.0F, 0.35F, 0.1F}},
            {1.0F, {1.0F, 0.8F, 0.35F}}}},
    GradientPreset{QT_TRANSLATE_NOOP("GradientPresets", "Soot"),
        {{0.0F, {0.01F, 0.01F, 0.01F}}, {0.5F, {0.08F, 0.07F, 0.065F}}, {1.0F, {0.35F, 0.33F, 0.31F}}}},
    GradientPreset{
        QT_TRANSLATE_NOOP("GradientPresets", "White"), {{0.0F, {1.0F, 1.0F, 1.0F}}, {1.0F, {1.0F, 1.0F, 1.0F}}}},
};

glm::vec3 hueShifted(const glm::vec3& colour, double degrees)
{
    const float most = std::max({colour.r, colour.g, colour.b}); // may be brighter than a screen
    if (most <= 0.0F) {
        return colour;
    }
    const glm::vec3 within = colour / most;
    float hue = 0.0F;
    float saturation = 0.0F;
    float value = 0.0F;
    QColor::fromRgbF(within.r, within.g, within.b).getHsvF(&hue, &saturation, &value);
    if (hue < 0.0F) {
        return colour; // grey
    }
    const double turned = static_cast<double>(hue) + degrees / 360.0;
    const QColor out = QColor::fromHsvF(static_cast<float>(turned - std::floor(turned)), saturation, value);
    return glm::vec3(out.redF(), out.greenF(), out.blueF()) * most;
}

} // namespace

std::span<const GradientPreset> gradientPresets()
{
    return kPresets;
}

QString nameOf(const GradientPreset& preset)
{
    return QCoreApplication::translate("GradientPresets", preset.name);
}

Gradient hueShifted(const Gradient& gradient, double degrees)
{
    Gradient out = gradient;
    for (int i = 0; i < out.count; ++i) {
        GradientStop& stop = out.storage[static_cast<std::size_t>(i)];
        stop.colour = hueShifted(stop.colour, degrees);
    }
    return out;
}

Gradient reversed(const Gradient& gradient)
{
    Gradient out = gradient;
    const auto count = static_cast<std::size_t>(gradient.count);
    for (std::size_t i = 0; i < count; ++i) {
        out.storage[i] = gradient.storage[count - 1 - i];
        out.storage[i].at = 1.0F - out.storage[i].at;
    }
    return out;
}

} // namespace fumage::ui
