#pragma once

#include <glm/vec3.hpp>

namespace fumage {

/// Light of black bodies: linear sRGB of their spectra, scaled so that one at the reference temperature has 1 in its
/// brightest channel. Colours outside of sRGB have their negative channels cut off. The same bits on every machine.
/// Source: Planck 1901; colour matching functions as sums of Gaussians: Wyman, Sloan, Shirley, "Simple Analytic
/// Approximations to the CIE XYZ Color Matching Functions", JCGT 2013; matrix of IEC 61966-2-1.
class BlackBody {
public:
    /// @param reference kelvin, 300 or more
    explicit BlackBody(float reference);

    /// @param kelvin temperature; below 300 K there is nothing to see and the result is 0
    /// About a microsecond.
    [[nodiscard]] glm::vec3 at(float kelvin) const;

private:
    float m_brightest; ///< channel at the reference temperature
};

} // namespace fumage
