#pragma once

#include "core/export/engines/engine.h"
#include "core/export/layer_output.h"
#include "core/export/sequence.h"
#include "core/export/sheets/packing.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fumage {

/// Largest edge of a flipbook's picture, which graphics cards still take as a texture, and most pixels of it (a GiB of
/// floats).
inline constexpr int kMaxSheetEdge = 16384;
inline constexpr std::size_t kMaxSheetPixels = std::size_t{1} << 26U;
/// Most pixels of all targets that its passes are made of.
inline constexpr std::size_t kMaxTargetPixels = std::size_t{1} << 27U;
/// Most columns or rows.
inline constexpr int kMaxSheetCells = 64;

/// Which layer a sheet is of, among those that are written.
struct SheetLayer {
    std::string name; ///< as the scene has it
    int number = 1; ///< in the order in which they are drawn
    int count = 1; ///< of them
};

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
    /// Which frames the cells show: the share of the way through the frames, 0 to 1, by the share of the way through
    /// the cells. Where it is level, smoke stands still, and where it falls, it goes back. The sheet is played in the
    /// same time. None: in even steps.
    std::optional<Curve> retime{};
    std::optional<FrameRange> untrimmed{}; ///< the frames before empty ones were left out, for the side-car
    std::vector<PackedPicture> packs{}; ///< more pictures; the sheet is rendered for their passes, too
    std::optional<LayerOutput> layers{}; ///< a sheet a layer; none: together
    std::optional<BlendSpace> blending{}; ///< of shares in formats without floats; none: what the engine blends in
    std::optional<SheetLayer> layer{}; ///< of one sheet of several: sheetsOf() sets it
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

/// The largest grid that frames fill, with no more columns and rows than are asked for; of several the one whose sides
/// are nearest to each other.
/// @param frames       1 or more
/// @param powersOfTwo  columns and rows are among 1, 2, 4, ...
[[nodiscard]] std::array<int, 2> gridWithin(int frames, int columns, int rows, bool powersOfTwo = false);

/// Whether each layer has a sheet of its own.
[[nodiscard]] bool isDivided(const FlipbookOptions& options);
/// Whether the sheets of layers are shares of one picture.
[[nodiscard]] bool isOfShares(const FlipbookOptions& options);
/// Whether one sheet is a share of the picture of several layers.
[[nodiscard]] bool isShareOfSeveral(const FlipbookOptions& sheet);
/// Whether the colour of one sheet is multiplied by alpha in every format: a share of several, but where the engine
/// blends straight colours alone.
[[nodiscard]] bool isPremultiplied(const FlipbookOptions& sheet);
/// In which numbers shares add up.
[[nodiscard]] BlendSpace blendSpaceOf(const FlipbookOptions& options);

/// All passes that a flipbook is rendered for, be it to be packed.
[[nodiscard]] PassSet renderedPasses(const FlipbookOptions& options);

} // namespace fumage
