#pragma once

#include "core/base/result.h"
#include "core/export/image_file.h"
#include "core/export/pass_picture.h"
#include "core/image_io/exr_file.h"
#include "core/rendering/layer_pictures.h"
#include "core/scene/scene.h"

#include <cstddef>
#include <stop_token>
#include <string>
#include <vector>

namespace fumage {

/// The masks that a scene has, without numbers: one a layer that is written.
[[nodiscard]] std::vector<LayerMask> masksOf(const Scene& scene);

/// Fills the masks of a sheet, cell by cell. Not thread-safe.
class LayerMasks {
public:
    explicit LayerMasks(const Scene& scene)
        : m_empty(masksOf(scene))
    {
    }

    /// Puts the masks of a cell into the sheet; those of all layers add up to the alpha of the picture, to the bit.
    /// @param sheet       with its grid; makes room with the first cell
    /// @param cell        where it stands
    /// @param picture     the cell of all layers
    /// @param layers      that it was made of, supersample times larger
    /// @error Cancelled
    /// O(pixels * layers), and see LayerPictures.
    [[nodiscard]] Status place(PassSheet& sheet, int cell, const Image& picture, int supersample, SpriteLayers layers,
        const std::stop_token& stop = {});

private:
    std::vector<LayerMask> m_empty;
    LayerPictures m_pictures;
};

/// The name of the channel in which an EXR has a mask: "mask_flames.Y".
[[nodiscard]] std::string channelOf(const LayerMask& mask);

/// Whether a format has room for masks of so many pixels.
/// @param channels that an EXR has beside them
/// @error OutOfRange where it has no channels of its own for them; TooLarge where nobody would read so many numbers
[[nodiscard]] Status checkMasks(const Scene& scene, ImageFormat format, std::int64_t pixels, std::size_t channels);

/// The masks of a sheet as a format holds them. Of halves each is a whole multiple of q, the ulp of the alpha as a
/// half: with s(k) the sum of the first k masks rounded to such a multiple, mask k is s(k) - s(k-1), which is a half as
/// every sum of them is. So they add up to the alpha of the file in halves, too.
[[nodiscard]] std::vector<LayerMask> storedMasks(const PassSheet& sheet, ImageFormat format);

/// Masks as targets of an EXR.
/// @param masks must stay
[[nodiscard]] std::vector<ExrChannels> targetsOf(const std::vector<LayerMask>& masks);

/// The masks of a sheet as a file of their own.
/// @param format holds floats
/// @error those of encodeExr()
[[nodiscard]] Result<std::vector<std::byte>> encodeMasks(
    const PassSheet& sheet, ImageFormat format, const ImageMetadata& notes, const std::stop_token& stop = {});

} // namespace fumage
