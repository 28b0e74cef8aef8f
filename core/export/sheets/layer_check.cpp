#include "core/export/sheets/layer_check.h"

#include "core/base/text.h"
#include "core/export/difference.h"
#include "core/export/manifest/manifest_parts.h"
#include "core/export/manifest/recorded.h"
#include "core/export/shown.h"
#include "core/export/sheets/flipbook.h"
#include "core/export/sheets/flipbook_files.h"
#include "core/image_io/exr_file.h"
#include "core/image_io/picture_pixels.h"
#include "core/preset/preset_file.h"
#include "core/rendering/view_transform.h"
#include "core/system/file.h"
#include "core/system/path.h"

#include <algorithm>

namespace fumage {

namespace {

constexpr std::size_t kMaxSheetBytes = std::size_t{1} << 31U;
constexpr float kSeen = 1.0F / 255.0F;

/// A sheet as somebody blends it: premultiplied RGBA, rows from the top.
struct Numbers {
    int width = 0;
    int height = 0;
    std::vector<float> pixels;
};

/// How the numbers of a file are read.
struct Reading {
    bool isLinear = false; ///< colours are decoded
    bool isPremultiplied = false; ///< else multiplied by alpha
};

Result<Numbers> numbersOfExr(std::span<const std::byte> file)
{
    const Result<ExrNumbers> exr = readExr(file);
    if (!exr) {
        return exr.error();
    }
    Numbers numbers{exr.value().width, exr.value().height, {}};
    numbers.pixels.resize(static_cast<std::size_t>(numbers.width) * static_cast<std::size_t>(numbers.height) * 4);
    for (const ExrNumbers::Channel& channel : exr.value().channels) {
        const std::size_t at = std::string_view("RGBA").find(channel.name);
        for (std::size_t i = 0; at != std::string_view::npos && i < channel.values.size(); ++i) {
            numbers.pixels[i * 4 + at] = channel.values[i];
        }
    }
    return numbers;
}

Result<Numbers> numbersOf(std::span<const std::byte> file, ImageFormat format, const Reading& how)
{
    if (holdsFloats(format)) {
        return numbersOfExr(file);
    }
    const Result<RgbaPixels> read = readPixels(file);
    if (!read) {
        return read.error();
    }
    constexpr float kFull = 65535.0F;
    Numbers numbers{read.value().width, read.value().height, {}};
    numbers.pixels.resize(read.value().values.size());
    for (std::size_t i = 0; i < numbers.pixels.size(); ++i) {
        const float stored = static_cast<float>(read.value().values[i]) / kFull;
        const float alpha = static_cast<float>(read.value().values[i - i % 4 + 3]) / kFull;
        const bool isAlpha = i % 4 == 3;
        const float number = how.isLinear && !isAlpha ? linearFromSrgb(stored) : stored;
        numbers.pixels[i] = isAlpha || how.isPremultiplied ? number : number * alpha;
    }
    return numbers;
}

/// What is to be seen in the cells.
void look(const Numbers& sheet, const SheetGrid& grid, LayerSheetScore& score)
{
    std::size_t seen = 0;
    for (int number = 0; number < grid.cells; ++number) {
        const SheetCell cell = grid.cell(number);
        std::size_t inCell = 0;
        for (int y = 0; y < cell.height; ++y) {
            for (int x = 0; x < cell.width; ++x) {
                const float* pixel = sheet.pixels.data()
                    + (static_cast<std::size_t>(cell.top + y) * static_cast<std::size_t>(sheet.width)
                          + static_cast<std::size_t>(cell.left + x))
                        * 4;
                inCell += *std::max_element(pixel, pixel + 4) >= kSeen ? 1 : 0;
                const bool isBorder = x == 0 || y == 0 || x + 1 == cell.width || y + 1 == cell.height;
                score.edgeAlpha = isBorder ? std::max(score.edgeAlpha, pixel[3]) : score.edgeAlpha;
            }
        }
        score.empty += inCell == 0 ? 1 : 0;
        seen += inCell;
    }
    score.seen = 4.0 * static_cast<double>(seen) / static_cast<double>(sheet.pixels.size());
}

/// Adds a layer to a picture, or draws it over it.
void blend(const Numbers& layer, LayerOutput output, std::vector<float>& picture)
{
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const float through = output == LayerOutput::Stacked ? 1.0F - layer.pixels[i - i % 4 + 3] : 1.0F;
        picture[i] = layer.pixels[i] + through * picture[i];
    }
}

double decibelsBetween(const std::vector<float>& picture, const std::vector<float>& truth)
{
    Difference difference;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        difference.add(std::min(1.0F, picture[i]), std::min(1.0F, truth[i]));
    }
    return difference.decibels();
}

/// The sheet of all layers, rendered again.
Result<Numbers> sheetOfAll(const LayeredSheets& layered, bool isLinear, const Task& task)
{
    Scene scene = layered.scene;
    if (writtenLayers(scene).size() > 1) {
        scene.output.background = Background::Transparent; // what there is belongs to no layer
    }
    FlipbookOptions whole = layered.options;
    whole.layers.reset();
    whole.passes = {Pass::Colour};
    whole.packs.clear();
    whole.engine = Engine::Generic;
    whole.preset.clear();
    const Result<std::vector<FlipbookFile>> made = encodeFlipbook(scene, whole, task);
    return made ? numbersOf(made.value().front().bytes, whole.format, {isLinear, false}) : made.error();
}

Result<Numbers> readSheet(
    const LayeredSheets& layered, const FlipbookOptions& sheet, const std::filesystem::path& file, bool isLinear)
{
    const Result<std::string> bytes = readFile(file, kMaxSheetBytes);
    if (!bytes && bytes.error().code == ErrorCode::FileNotFound) {
        return Error{ErrorCode::FileNotFound,
            makeMessage("the sheet of layer %1 is missing", inQuotes(sheet.layer->name)), file.string(),
            makeMessage("Keep the sheets of all layers in one folder, or export them again")};
    }
    Result<Numbers> numbers = bytes
        ? numbersOf(std::as_bytes(std::span(bytes.value())), sheet.format, {isLinear, isPremultiplied(sheet)})
        : Result<Numbers>(bytes.error());
    if (!numbers) {
        Error error = numbers.error();
        error.place = file.string();
        return error;
    }
    const int width = layered.scene.output.width * sheet.columns;
    const int height = layered.scene.output.height * sheet.rows;
    if (numbers.value().width != width || numbers.value().height != height) {
        return Error{ErrorCode::OutOfRange,
            makeMessage("the sheet of layer %1 has %2 x %3 pixels, and not %4 x %5", inQuotes(sheet.layer->name),
                numbers.value().width, numbers.value().height, width, height),
            file.string(), makeMessage("Export the sheets of all layers together")};
    }
    return numbers;
}

Error notLayered(const std::filesystem::path& file)
{
    return {ErrorCode::OutOfRange, makeMessage("this manifest is of no sheets of layers"), file.string(),
        makeMessage("Name one that was written with --layers-as, or a preset")};
}

Result<std::optional<LayeredSheets>> fromManifest(const std::filesystem::path& file)
{
    const Result<Manifest> manifest = readManifest(file);
    if (!manifest) {
        return manifest.error();
    }
    Result<FlipbookOptions> options = flipbookOf(manifest.value().job);
    if (!options || !isDivided(options.value()) || manifest.value().files.empty()) {
        return notLayered(file);
    }
    const std::filesystem::path folder =
        file.parent_path() / pathFrom(manifest.value().files.front().file).parent_path();
    options.value().output = folder / options.value().output;
    return std::optional(LayeredSheets{manifest.value().job.scene, std::move(options).value()});
}

Result<std::optional<LayeredSheets>> fromSheet(const std::filesystem::path& file)
{
    const Result<PresetReading> reading = readPresetFile(file);
    if (!reading) {
        return reading.error();
    }
    const Shown shown = shownBy(reading.value());
    if (!shown.sheet || !isDivided(*shown.sheet)) {
        return std::optional<LayeredSheets>();
    }
    LayeredSheets layered{reading.value().preset.scene, *shown.sheet};
    const std::string stem = file.stem().string();
    for (const WrittenLayer& layer : writtenLayers(layered.scene)) {
        for (const Pass pass : listOf(layered.options.passes)) {
            const std::string ending =
                "_" + layer.word + (pass == Pass::Colour ? std::string() : "_" + fileNameOf(pass));
            if (stem.size() > ending.size() && stem.ends_with(ending)) {
                layered.options.output = file.parent_path()
                    / pathFrom(stem.substr(0, stem.size() - ending.size()) + file.extension().string());
                return std::optional(layered);
            }
        }
    }
    return Error{ErrorCode::OutOfRange, makeMessage("the name of this sheet does not say which layer it is of"),
        file.string(), makeMessage("Name it as it was exported, such as fire_flames.png, or its manifest")};
}

} // namespace

Result<std::optional<LayeredSheets>> findLayeredSheets(const std::filesystem::path& file)
{
    return isManifest(file) ? fromManifest(file) : fromSheet(file);
}

Result<LayeredScore> scoreLayers(const LayeredSheets& layered, const Task& task)
{
    const FlipbookOptions& options = layered.options;
    if (!options.passes.has(Pass::Colour)) {
        return Error{ErrorCode::OutOfRange, makeMessage("these sheets have no colour to be put together"),
            options.output.string(), makeMessage("Export them with colour among the passes")};
    }
    const bool isTogether = isOfShares(options);
    const bool isLinear = blendSpaceOf(options) == BlendSpace::Linear && !holdsFloats(options.format);
    const SheetGrid grid{
        options.columns, options.columns * options.rows, layered.scene.output.width, layered.scene.output.height};
    LayeredScore score;
    std::vector<float> picture;
    for (const FlipbookOptions& sheet : sheetsOf(layered.scene, options)) {
        const std::filesystem::path file = picturesOf(sheet).front();
        const Result<Numbers> numbers = readSheet(layered, sheet, file, isLinear);
        if (!numbers) {
            return numbers.error();
        }
        score.sheets.push_back({sheet.layer->name, file});
        look(numbers.value(), grid, score.sheets.back());
        picture.resize(numbers.value().pixels.size(), 0.0F);
        if (isTogether) {
            blend(numbers.value(), *options.layers, picture);
        }
    }
    if (isTogether) {
        const Result<Numbers> whole = sheetOfAll(layered, isLinear, task);
        if (!whole) {
            return whole.error();
        }
        score.decibels = decibelsBetween(picture, whole.value().pixels);
    }
    return score;
}

} // namespace fumage
