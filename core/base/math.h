#pragma once

namespace fumage {

inline constexpr float kPi = 3.14159265358979324F;
inline constexpr float kTau = 6.28318530717958648F;

/// An angle in radians.
[[nodiscard]] constexpr float radians(float degrees)
{
    return degrees * (kPi / 180.0F);
}

/// From 0 to 1 with level ends, for t in [0, 1]: 3 t^2 - 2 t^3.
[[nodiscard]] constexpr float smoothStep(float t)
{
    return t * t * (3.0F - 2.0F * t);
}

/// Scalar functions with the same bits on every machine and the same bits as one lane of the SIMD kernels.
/// Errors and ranges: see math-inl.h, of which these are the one-lane form.
[[nodiscard]] float portableSin(float angle);
/// As portableSin().
[[nodiscard]] float portableCos(float angle);
/// e^x, see portableSin().
[[nodiscard]] float portableExp(float x);
/// The natural logarithm of x > 0, see portableSin().
[[nodiscard]] float portableLog(float x);

/// x^y for x >= 0 as e^(y ln x); 0^y is 0 for y > 0 and 1 for y = 0.
[[nodiscard]] float portablePow(float x, float y);

} // namespace fumage
