#pragma once

#include "core/image_io/image_metadata.h"

#include <string_view>

namespace fumage {

/// Reads the notes of a picture that anybody may have made; no pixel is looked at. Those of a PNG may stand behind its
/// pixels, where other programs put them. O(kPictureHead + kMaxNoteBytes), and a part of a few bytes a chunk of a PNG.
/// @return preset, frame and sheet; without a preset where the picture carries none, as TGA never does
/// @error  Syntax: it is none of them, or broken before its pixels, or its preset is damaged or too long; that of the
/// reader
[[nodiscard]] Result<ImageMetadata> readImageMetadata(const PartReader& file);
/// The same of a file in memory.
/// @param file all of its bytes; of an EXR its head will do
[[nodiscard]] Result<ImageMetadata> readImageMetadata(std::string_view file);

} // namespace fumage
