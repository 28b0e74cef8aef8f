#pragma once

#include "core/base/result.h"
#include "core/picture_files/picture_notes.h"
#include "core/picture_files/picture_pixels.h"

#include <cstddef>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace fumage {

/// Channels that belong together: interleaved floats, rows from the top.
struct ExrLayer {
    std::string name; ///< stands before each channel, with a dot; empty: the picture itself
    std::string channels = "RGBA"; ///< a letter each
    std::span<const float> values;
};

/// "Y", "RGB" or "RGBA".
[[nodiscard]] std::string exrChannels(int count);

/// A picture in memory for OpenEXR.
struct ExrPixels {
    int width = 0;
    int height = 0;
    std::vector<ExrLayer> layers;
    bool half = true; ///< else 32-bit floats
    PictureNotes notes{};
    bool isLight = true; ///< premultiplied colours; else numbers that have no primaries
};

/// @error WriteFailed, Cancelled
[[nodiscard]] Result<std::vector<std::byte>> encodeExr(const ExrPixels& pixels, const std::stop_token& stop = {});

/// readPictureNotes() of an EXR.
[[nodiscard]] Result<PictureNotes> readExrNotes(std::string_view head);

/// Reads all channels of an EXR that anybody may have made, to its end.
/// @error as readPixels()
[[nodiscard]] Result<ExrNumbers> readExr(std::span<const std::byte> file);

} // namespace fumage
