#pragma once

#include "core/base/result.h"
#include "core/image_io/image_metadata.h"
#include "core/image_io/pixel_arrays.h"

#include <cstddef>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace fumage {

/// Channels that belong together: interleaved floats, rows from the top.
struct ExrChannels {
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
    std::vector<ExrChannels> targets;
    bool half = true; ///< else 32-bit floats
    ImageMetadata notes{};
    bool isLight = true; ///< premultiplied colours; else numbers that have no primaries
};

/// Longest text of an attribute that is written, in bytes: ffmpeg up to 5.1 goes on reading attributes within one that
/// is longer than 255.
inline constexpr std::size_t kMaxExrTextBytes = 240;

/// @error WriteFailed, Cancelled
[[nodiscard]] Result<std::vector<std::byte>> encodeExr(const ExrPixels& pixels, const std::stop_token& stop = {});

/// readImageMetadata() of an EXR.
[[nodiscard]] Result<ImageMetadata> readExrNotes(std::string_view head);

/// Reads the channels of an EXR to its end, one after the other by their names, in parts of some MiB, so that memory is
/// bounded. The file is read again for every few channels.
/// @param begin told width and height before all else
/// @param part  numbers that follow on those before, rows from the top; a name that is another begins a channel
/// @error as readPixels(); that of the reader
[[nodiscard]] Status readExrParts(const PartReader& file, const std::function<void(int width, int height)>& begin,
    const std::function<void(const std::string& channel, std::span<const float> part)>& part);

/// Reads all channels of an EXR that anybody may have made, to its end.
/// @error as readPixels()
[[nodiscard]] Result<ExrNumbers> readExr(std::span<const std::byte> file);

} // namespace fumage
