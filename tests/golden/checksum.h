#pragma once

#include "core/rendering/image.h"
#include "core/scene/scene.h"

#include <map>
#include <string>

namespace fumage::tests {

// What golden.txt has a line of, for every built-in preset. No Qt: machines without it compute them, too.

inline constexpr int kGoldenFrame = 45;

/// A built-in preset as a small picture of few particles.
[[nodiscard]] Scene goldenScene(const std::string& id);
/// Another scene, likewise.
[[nodiscard]] Scene goldenScene(const Scene& preset);

/// The picture of it that golden.txt is about.
[[nodiscard]] Result<Image> goldenPicture(const Scene& scene);

/// "id checksum", of the picture's floats.
[[nodiscard]] std::string goldenLine(const std::string& id, const Image& image);

/// The lines of such a file by the ids of their presets; none where it cannot be read.
[[nodiscard]] std::map<std::string, std::string> goldenLines(const std::string& path);

} // namespace fumage::tests
