#include "core/lighting/black_body.h"

#include "core/base/math.h"

#include <algorithm>
#include <array>

#include <glm/common.hpp>

namespace fumage {

namespace {

constexpr float kDarkest = 300.0F;

constexpr float kFirstNanometres = 380.0F;
constexpr float kStepNanometres = 10.0F;
constexpr std::size_t kSamples = 41;

/// One lobe of a colour matching function: a Gaussian with a width on either side.
float lobe(float nanometres, float height, float middle, float below, float above)
{
    const float t = (nanometres - middle) / (nanometres < middle ? below : above);
    return height * portableExp(-0.5F * t * t);
}

/// CIE 1931 XYZ of light of one wavelength.
glm::vec3 colourMatching(float nanometres)
{
    const auto at = [&](float height, float middle, float below, float above) {
        return lobe(nanometres, height, middle, below, above);
    };
    return {at(1.056F, 599.8F, 37.9F, 31.0F) + at(0.362F, 442.0F, 16.0F, 26.7F) + at(-0.065F, 501.1F, 20.4F, 26.2F),
        at(0.821F, 568.8F, 46.9F, 40.5F) + at(0.286F, 530.9F, 16.3F, 31.1F),
        at(1.217F, 437.0F, 11.8F, 36.0F) + at(0.681F, 459.0F, 26.0F, 13.8F)};
}

/// Linear sRGB of a black body in units of no meaning, the same ones for every temperature.
glm::vec3 spectrumColour(float kelvin)
{
    static const std::array<glm::vec3, kSamples> matching = [] {
        std::array<glm::vec3, kSamples> out{};
        for (std::size_t i = 0; i < kSamples; ++i) {
            out[i] = colourMatching(kFirstNanometres + kStepNanometres * static_cast<float>(i));
        }
        return out;
    }();
    constexpr float kSecondRadiation = 1.438776877e7F; // h c / k, nm K
    glm::vec3 xyz(0.0F);
    for (std::size_t i = 0; i < kSamples; ++i) {
        const float nanometres = kFirstNanometres + kStepNanometres * static_cast<float>(i);
        const float decay = portableExp(-kSecondRadiation / (nanometres * kelvin));
        const float micrometres = 0.001F * nanometres;
        const float fifth = micrometres * micrometres * micrometres * micrometres * micrometres;
        xyz += matching[i] * (decay / ((1.0F - decay) * fifth));
    }
    const glm::vec3 rgb(3.2404542F * xyz.x - 1.5371385F * xyz.y - 0.4985314F * xyz.z,
        -0.9692660F * xyz.x + 1.8760108F * xyz.y + 0.0415560F * xyz.z,
        0.0556434F * xyz.x - 0.2040259F * xyz.y + 1.0572252F * xyz.z);
    return glm::max(rgb, glm::vec3(0.0F));
}

} // namespace

BlackBody::BlackBody(float reference)
{
    const glm::vec3 colour = spectrumColour(std::max(reference, kDarkest));
    m_brightest = std::max({colour.r, colour.g, colour.b, 1e-30F});
}

glm::vec3 BlackBody::at(float kelvin) const
{
    return kelvin < kDarkest ? glm::vec3(0.0F) : spectrumColour(kelvin) / m_brightest;
}

} // namespace fumage
