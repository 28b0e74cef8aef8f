#pragma once

#include "core/export/sequence.h"

#include <optional>

namespace fumage {

/// Largest edge of a flipbook's picture, which graphics cards still take as a texture, and most pixels of it (a GiB of floats).
inline constexpr int kMaxSheetEdge = 16384;
inline constexpr std::size_t kMaxSheetPixels = std::size_t{1} << 26U;
/// Most columns or rows.
inline constexpr int kMaxSheetCells = 64;

struct FlipbookOptions {
    std::filesystem::path output; ///< of the picture; an ending that is missing is added
    int columns = 8; ///< 1..kMaxSheetCells
    int rows = 8;
    FrameRange frames; ///< at least as many as cells; spread evenly over them
    ImageFormat format = ImageFormat::Png8;
};

/// Smoke that reaches the border of cells: it ends there abruptly, and seeps into the next cell when filtered.
struct CutOff {
    bool left = false, right = false, top = false, bottom = false; ///< edges that it reaches
    int firstFrame = 0; ///< of those in which it does
    int lastFrame = 0;
    float distance = 0.0F; ///< of the camera from its target, m, that would do; 0: the camera has no target
};

/// What engines must be told to play a flipbook; also in the file beside it.
struct Flipbook {
    std::filesystem::path picture;
    std::filesystem::path description;
    double cellsPerSecond = 0.0; ///< keeps the speed of the effect
    float edgeAlpha = 0.0F; ///< most alpha on a cell's border
    std::optional<CutOff> cutOff; ///< where edgeAlpha reaches 1/255
};

/// Frame that a cell shows.
/// @param cell 0 at the top left, counted along rows
[[nodiscard]] int frameOfCell(const FlipbookOptions& options, int cell);

/// The file beside the picture of a flipbook that says how it is to be played.
[[nodiscard]] std::filesystem::path descriptionOf(const std::filesystem::path& picture);

/// Renders frames into one picture of columns by rows cells, each of effect.output's size, first at the top left, then along the rows, as Unity, Unreal,
/// Godot and Effekseer read them. PNG: straight alpha in which transparent pixels have the colour of the smoke next to them, so that filtering and
/// mipmaps bring no dark rims. Beside it NAME.flipbook.json says how it is to be played (not NAME.json, which may be a preset). Both are written whole or not at all.
/// @error TooLarge, OutOfRange, those of renderSequence()
[[nodiscard]] Result<Flipbook> renderFlipbook(const Effect& effect, const FlipbookOptions& options, const Progress& progress, const std::stop_token& stop = {});

} // namespace fumage
