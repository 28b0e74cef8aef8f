#pragma once

#include "core/effect/bitmap.h"

#include <filesystem>
#include <string_view>

namespace fumage {

/// Reads a picture for an effect.
/// @error those of readFile() with kMaxPictureBytes, and of Bitmap::read(); the place is the path
[[nodiscard]] Result<Bitmap> readPictureFile(const std::filesystem::path& path);

/// Puts the picture itself where "key=value" or "layer/key=value" names a file of one, as base64. Any other assignment
/// stays as it is, so does what is base64 of a PNG already.
/// @error that of readPictureFile()
[[nodiscard]] Result<std::string> withPictureRead(std::string_view assignment);

} // namespace fumage
