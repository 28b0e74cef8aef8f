#pragma once

#include <glm/vec3.hpp>

namespace fumage {

/// Light of a black body: linear sRGB of its spectrum, scaled so that one at the reference temperature has 1 in its brightest channel.
/// Colours outside of sRGB have their negative channels cut off.
/// @param kelvin temperature; below 300 K there is nothing to see and the result is 0
/// @param reference kelvin, 300 or more
/// The same bits on every machine. About 3 microseconds.
/// Source: Planck 1901; colour matching functions as sums of Gaussians: Wyman, Sloan, Shirley, "Simple Analytic Approximations to the CIE XYZ
/// Color Matching Functions", JCGT 2013; matrix of IEC 61966-2-1.
[[nodiscard]] glm::vec3 blackBody(float kelvin, float reference);

} // namespace fumage
