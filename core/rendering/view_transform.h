#pragma once

#include "core/effect/effect.h"
#include "core/rendering/image.h"

#include <cstdint>
#include <vector>

namespace fumage {

/// A picture as files and screens take it: straight alpha, sRGB.
template <class Channel>
struct EncodedImage {
    int width = 0;
    int height = 0;
    RawArray<Channel> pixels; ///< width * height * 4, row-major, origin top-left
};

/// How opaque what is encoded is.
enum class Cover {
    Alpha, ///< as the picture says
    Light, ///< at least as much as its light shows: a colour of 1 at most, times alpha, has no more
};

/// How opaque smoke under this light is encoded: clear flames by their light.
[[nodiscard]] Cover coverOf(const Light& light);

/// Encodes linear light for display: exposure, then the view transform, then the sRGB curve (IEC 61966-2-1), with straight alpha.
/// Filmic is the fit of Narkowicz, "ACES Filmic Tone Mapping Curve", 2015.
/// @param cover Light for clear flames, which give more light than their alpha covers: over black they are then what they are in the picture;
///              smoke, whose colour is 1 at most, stays as it is, and the one goes over into the other
/// O(pixels). The same bits for any thread count and instruction set.
void encode(const Image& image, const Output& output, EncodedImage<std::uint8_t>& out, Cover cover = Cover::Alpha);
/// The same in 16 bits.
void encode(const Image& image, const Output& output, EncodedImage<std::uint16_t>& out, Cover cover = Cover::Alpha);

/// What light is multiplied by: 2^stops.
[[nodiscard]] float exposureGain(float stops);

/// The linear light, before exposure, from which on a channel is shown as 1: what is brighter looks the same.
[[nodiscard]] float brightestShown(const Output& output);

/// The sRGB curve for one linear value of 0 or more; values above 1 go on along the curve.
[[nodiscard]] float srgbFromLinear(float linear);

/// Its inverse, for values of 0 or more.
[[nodiscard]] float linearFromSrgb(float encoded);

} // namespace fumage
