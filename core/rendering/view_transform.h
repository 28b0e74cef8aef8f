#pragma once

#include "core/scene/scene.h"
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
[[nodiscard]] Cover coverOf(const Glow& glow);
/// The same of a scene: by their light if one of its layers that are seen has clear flames.
[[nodiscard]] Cover coverOf(const Scene& scene);

/// Encodes linear light for display: exposure, then the view transform, then the sRGB curve (IEC 61966-2-1), with
/// straight alpha. Filmic is the fit of Narkowicz, "ACES Filmic Tone Mapping Curve", 2015, of the brightest channel;
/// the others keep their ratio to it, so that hues stay, and very bright light goes over into white. Where output has a
/// colour behind the smoke the picture is opaque, as encodeOver() makes it.
/// @param cover Light for clear flames, which give more light than their alpha covers: over black they are then what
///              they are in the picture; smoke, whose colour is 1 at most, stays as it is, and the one goes over into
///              the other
/// O(pixels). The same bits for any thread count and instruction set.
void encode(const Image& image, const Output& output, EncodedImage<std::uint8_t>& out, Cover cover = Cover::Alpha);
/// The same in 16 bits.
void encode(const Image& image, const Output& output, EncodedImage<std::uint16_t>& out, Cover cover = Cover::Alpha);

/// What is behind smoke that is shown: a colour or a checkerboard, linear and as it is to be seen, whatever exposure
/// and view transform make of light.
struct Backing {
    glm::vec3 colour{0.0F};
    glm::vec3 other{0.0F}; ///< of every second square
    int square = 0; ///< edge of a checkerboard's squares, pixels; 0: there is only one colour
};

/// Encodes smoke over what is behind it: the view transform is the light's, and what it shows is blended in linear
/// light with the backing, which is seen exactly as it is where nothing is in front of it. Smoke has the colours that
/// it has in transparent pictures; light that its alpha does not cover is what it is over black. (Blending before the
/// transform would need a backing many times as bright as white, through which no thin smoke is seen.)
/// @param out opaque
/// O(pixels). The same bits for any thread count and instruction set.
void encodeOver(const Image& image, const Output& output, const Backing& backing, EncodedImage<std::uint8_t>& out);

/// What light is multiplied by: 2^stops.
[[nodiscard]] float exposureGain(float stops);

/// The linear light, before exposure, from which on a channel is shown as 1: brighter greys look the same.
[[nodiscard]] float brightestShown(const Output& output);

/// The sRGB curve for one linear value of 0 or more; values above 1 go on along the curve.
[[nodiscard]] float srgbFromLinear(float linear);

/// Its inverse, for values of 0 or more.
[[nodiscard]] float linearFromSrgb(float encoded);

} // namespace fumage
