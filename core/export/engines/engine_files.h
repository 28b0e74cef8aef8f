#pragma once

#include "core/base/result.h"
#include "core/effect/effect.h"
#include "core/export/engines/engine.h"
#include "core/export/image_file.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fumage {

/// One picture of a flipbook, as it is written.
struct EnginePicture {
    std::optional<Pass> pass; ///< none: it is packed
    std::filesystem::path file;
    std::span<const std::byte> bytes;
    bool isSrgb = false; ///< else its numbers are linear
    bool isExact = false; ///< vectors and normals are no colours: mixed or compressed as such they point elsewhere
};

/// All that files for engines tell of a flipbook.
struct EngineSheet {
    const Effect& effect; ///< its output is a cell
    int columns = 1;
    int rows = 1;
    double cellsPerSecond = 1.0;
    bool loops = false; ///< it is played over and over
    PassStyle style;
    PassScales scales;
    std::vector<EnginePicture> pictures; ///< the first is the colour's
};

/// The files that make an engine play a flipbook.
/// @param pictures those of the flipbook; the first is the colour's
[[nodiscard]] std::vector<std::filesystem::path> engineFilesOf(Engine engine, std::span<const std::filesystem::path> pictures);

/// What stands in them, in the same order.
[[nodiscard]] std::vector<std::string> makeEngineFiles(Engine engine, const EngineSheet& sheet);

/// Whether an engine takes such pictures.
/// @error OutOfRange, with what to choose
[[nodiscard]] Status checkEngine(Engine engine, PassSet passes, ImageFormat format);

} // namespace fumage
