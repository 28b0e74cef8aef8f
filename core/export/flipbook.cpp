#include "core/export/flipbook.h"

#include "core/base/file.h"
#include "core/rendering/renderer.h"
#include "core/simulation/simulator.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace fumage {

namespace {

Status check(const Effect& effect, const FlipbookOptions& options)
{
    const auto inRange = [](int count) { return count >= 1 && count <= kMaxSheetCells; };
    if (!inRange(options.columns) || !inRange(options.rows)) {
        return Error{ErrorCode::OutOfRange, "a flipbook of " + std::to_string(options.columns) + " x " + std::to_string(options.rows) + " cells", "", "Use 1 to " + std::to_string(kMaxSheetCells) + " columns and rows"};
    }
    const int cells = options.columns * options.rows;
    if (options.frames.count() < cells) {
        return Error{ErrorCode::OutOfRange, std::to_string(options.frames.count()) + " frames do not fill " + std::to_string(cells) + " cells", "", "Choose more frames or fewer columns and rows"};
    }
    const std::int64_t width = static_cast<std::int64_t>(effect.output.width) * options.columns;
    const std::int64_t height = static_cast<std::int64_t>(effect.output.height) * options.rows;
    if (width > kMaxSheetEdge || height > kMaxSheetEdge || width * height > static_cast<std::int64_t>(kMaxSheetPixels)) {
        return Error{ErrorCode::TooLarge, "a flipbook of " + std::to_string(width) + " x " + std::to_string(height) + " pixels", "",
            "Choose smaller or fewer cells: edges up to " + std::to_string(kMaxSheetEdge) + " pixels, at most " + std::to_string(kMaxSheetPixels >> 20U) + " million in all"};
    }
    return Done{};
}

void place(const Image& cell, Image& sheet, int left, int top)
{
    for (int y = 0; y < cell.height; ++y) {
        std::copy_n(cell.row(y), static_cast<std::size_t>(cell.width) * 4, sheet.row(top + y) + static_cast<std::size_t>(left) * 4);
    }
}

float mostAlphaOnTheBorder(const Image& cell)
{
    float most = 0.0F;
    for (int x = 0; x < cell.width; ++x) {
        most = std::max({most, cell.at(x, 0).a, cell.at(x, cell.height - 1).a});
    }
    for (int y = 0; y < cell.height; ++y) {
        most = std::max({most, cell.at(0, y).a, cell.at(cell.width - 1, y).a});
    }
    return most;
}

std::string describe(const Effect& effect, const FlipbookOptions& options, const Flipbook& flipbook)
{
    const bool png = fileEnding(options.format) == ".png";
    nlohmann::ordered_json json;
    json["format"] = "fumage-flipbook";
    json["version"] = 1;
    json["picture"] = flipbook.picture.filename().string();
    json["columns"] = options.columns;
    json["rows"] = options.rows;
    json["cell_width"] = effect.output.width;
    json["cell_height"] = effect.output.height;
    json["order"] = "left to right, then top to bottom";
    json["cells_per_second"] = flipbook.cellsPerSecond;
    json["seconds"] = options.columns * options.rows / flipbook.cellsPerSecond;
    json["loop"] = effect.timeline.loop;
    json["alpha"] = png ? "straight" : "premultiplied";
    json["colour"] = png ? "sRGB" : "linear";
    return json.dump(2) + "\n";
}

/// Renders the cells into the sheet.
/// @return most alpha on a cell's border, where the background is transparent
Result<float> renderCells(const Effect& effect, const FlipbookOptions& options, Image& sheet, const SequenceProgress& progress, const std::stop_token& stop)
{
    const Output& output = effect.output;
    const SampledEffect smoke = sampled(effect);
    Simulator simulator(smoke);
    Renderer renderer;
    Image cell;
    float edgeAlpha = 0.0F;
    const int cells = options.columns * options.rows;
    sheet.resize(output.width * options.columns, output.height * options.rows);
    for (int number = 0; number < cells; ++number) {
        const Result<std::shared_ptr<const Frame>> frame = simulator.frame(frameOfCell(options, number), stop);
        if (!frame) {
            return frame.error();
        }
        if (Status status = renderer.render(*frame.value(), smoke, output.width, output.height, cell, stop); !status) {
            return status.error();
        }
        if (output.background == Background::Transparent) {
            edgeAlpha = std::max(edgeAlpha, mostAlphaOnTheBorder(cell));
        }
        place(cell, sheet, number % options.columns * cell.width, number / options.columns * cell.height);
        progress(number + 1, cells);
    }
    return edgeAlpha;
}

} // namespace

int frameOfCell(const FlipbookOptions& options, int cell)
{
    const std::int64_t index = static_cast<std::int64_t>(cell) * options.frames.count() / (options.columns * options.rows);
    return options.frames.at(static_cast<int>(index));
}

Result<Flipbook> renderFlipbook(const Effect& effect, const FlipbookOptions& options, const SequenceProgress& progress, const std::stop_token& stop)
{
    if (Status status = check(effect, options); !status) {
        return status.error();
    }
    Flipbook flipbook;
    flipbook.picture = withEnding(options.output, fileEnding(options.format));
    flipbook.description = std::filesystem::path(flipbook.picture).replace_extension(".flipbook.json");
    const double frames = static_cast<double>(options.frames.count()) * options.frames.step;
    flipbook.cellsPerSecond = options.columns * options.rows * static_cast<double>(effect.timeline.frameRate) / frames;
    if (Status status = makeFolderOf(flipbook.picture); !status) {
        return status.error();
    }

    Image sheet;
    const Result<float> edgeAlpha = renderCells(effect, options, sheet, progress, stop);
    if (!edgeAlpha) {
        return edgeAlpha.error();
    }
    flipbook.edgeAlpha = edgeAlpha.value();
    const Result<std::vector<std::byte>> bytes = encodeSheet(sheet, effect.output, options.format, effect.output.width, effect.output.height);
    if (!bytes) {
        Error error = bytes.error();
        error.place = flipbook.picture.string();
        return error;
    }
    const std::string description = describe(effect, options, flipbook);
    if (Status status = writePairAtomically({flipbook.picture, bytes.value()}, {flipbook.description, std::as_bytes(std::span(description))}); !status) {
        return status.error();
    }
    return flipbook;
}

} // namespace fumage
