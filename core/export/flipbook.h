#pragma once

#include "core/export/engines/engine.h"
#include "core/export/frame_source.h"
#include "core/export/packing.h"
#include "core/export/sequence.h"

#include <array>
#include <optional>

namespace fumage {

/// Largest edge of a flipbook's picture, which graphics cards still take as a texture, and most pixels of it (a GiB of floats).
inline constexpr int kMaxSheetEdge = 16384;
inline constexpr std::size_t kMaxSheetPixels = std::size_t{1} << 26U;
/// Most pixels of all layers that its passes are made of.
inline constexpr std::size_t kMaxLayerPixels = std::size_t{1} << 27U;
/// Most columns or rows.
inline constexpr int kMaxSheetCells = 64;

struct FlipbookOptions {
    std::filesystem::path output; ///< of the picture; an ending that is missing is added
    int columns = 8; ///< 1..kMaxSheetCells
    int rows = 8;
    FrameRange frames; ///< at least as many as cells; spread evenly over them
    ImageFormat format = ImageFormat::Png8;
    PassSet passes{Pass::Colour}; ///< one picture each; none only beside packed ones
    PassStyle style{}; ///< of those that are not the colour
    Engine engine = Engine::Generic; ///< the files that make it play are written, too
    std::string preset{}; ///< that the pictures carry, as JSON; empty: none
    /// Which frames the cells show: the share of the way through the frames, 0 to 1, by the share of the way through the cells. Where it is level, smoke stands still,
    /// and where it falls, it goes back. The sheet is played in the same time. None: in even steps.
    std::optional<Curve> retime{};
    std::optional<FrameRange> untrimmed{}; ///< the frames before empty ones were left out, for the side-car
    std::vector<PackedPicture> packs{}; ///< more pictures; the sheet is rendered for their passes, too
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
    std::filesystem::path picture; ///< the first
    int files = 2; ///< pictures, what engines need, and the description
    std::filesystem::path description;
    double cellsPerSecond = 0.0; ///< keeps the speed of the effect
    bool loops = false; ///< it is played over and over: its cells are whole turns of a loop
    float edgeAlpha = 0.0F; ///< most alpha on a cell's border
    std::optional<CutOff> cutOff; ///< where edgeAlpha reaches 1/255
};

/// The largest grid that frames fill, with no more columns and rows than are asked for; of several the one whose sides are nearest to each other.
/// @param frames       1 or more
/// @param powersOfTwo  columns and rows are among 1, 2, 4, ...
[[nodiscard]] std::array<int, 2> gridWithin(int frames, int columns, int rows, bool powersOfTwo = false);

/// The file beside the picture of a flipbook that says how it is to be played.
[[nodiscard]] std::filesystem::path descriptionOf(const std::filesystem::path& picture);

/// All passes that a flipbook is rendered for, be it to be packed.
[[nodiscard]] PassSet renderedPasses(const FlipbookOptions& options);

/// The picture of a pass: the colour's has the name that was given, others have what they are before the ending, as in smoke_sixway_a.png.
/// @param picture with its ending
[[nodiscard]] std::filesystem::path pictureOf(const std::filesystem::path& picture, Pass pass);

/// All files that a flipbook is made of: its pictures in the order of the passes, packed ones, what its engine needs, then the description.
[[nodiscard]] std::vector<std::filesystem::path> filesOf(const FlipbookOptions& options);
/// The pictures alone.
[[nodiscard]] std::vector<std::filesystem::path> picturesOf(const FlipbookOptions& options);

/// Renders frames into one picture of columns by rows cells, each of effect.output's size, first at the top left, then along the rows, as Unity, Unreal,
/// Godot and Effekseer read them. PNG: straight alpha in which transparent pixels have the colour of the smoke next to them, so that filtering and
/// mipmaps bring no dark rims. Other passes are pictures of their own beside it, linear and without view transform. NAME.flipbook.json says how it is to be played (not NAME.json, which may be a preset). What makes an engine play it lies beside
/// it, too. All are written whole or not at all.
/// @error TooLarge before allocating, OutOfRange, those of checkEngine(), checkPacks() and renderSequence()
[[nodiscard]] Result<Flipbook> renderFlipbook(const Effect& effect, const FlipbookOptions& options, const Progress& progress, const std::stop_token& stop = {});

/// A file of a flipbook, not written.
struct FlipbookFile {
    std::filesystem::path path;
    std::vector<std::byte> bytes;
};

/// The files that renderFlipbook() writes, in the order of filesOf(); nothing is written.
/// @error those of renderFlipbook()
[[nodiscard]] Result<std::vector<FlipbookFile>> encodeFlipbook(const Effect& effect, const FlipbookOptions& options, const Progress& progress, const std::stop_token& stop = {});

/// renderFlipbook() of frames that are there already. Nothing is known of smoke that is cut off.
/// @param options whose only pass is the colour
/// @error OutOfRange where other passes are asked for; those of renderFlipbook() and of the frames
[[nodiscard]] Result<Flipbook> joinFlipbook(const Effect& effect, const FlipbookOptions& options, const FrameSource& frames, const Progress& progress, const std::stop_token& stop = {});

} // namespace fumage
