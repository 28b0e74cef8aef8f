#include "core/export/sheets/flipbook.h"

#include "core/system/file.h"
#include "core/export/loop.h"
#include "core/export/sheets/border_watch.h"
#include "core/export/sheets/cell_frames.h"
#include "core/export/engines/engine_files.h"
#include "core/export/layer_masks.h"
#include "core/export/sheets/flipbook_check.h"
#include "core/export/sheets/flipbook_description.h"
#include "core/export/sheets/flipbook_files.h"
#include "core/export/sheets/flipbook_pictures.h"
#include "core/export/sheets/layer_cells.h"
#include "core/export/sheets/layer_colours.h"
#include "core/export/sheets/sheet.h"

#include <iterator>

namespace fumage {

namespace {

/// Renders the cells into the sheet, and says of the flipbook whether they hold all smoke.
/// @param layers gets the cells of each layer; null: nobody asks for them
Status renderCells(const Scene& scene, const FlipbookOptions& options, PassSheet& sheet, LayerCells* layers,
    Flipbook& flipbook, const ExportTask& task)
{
    BorderWatch borders(scene);
    PassSet rendered = renderedPasses(options);
    rendered.add(Pass::Alpha); // it tells what is cut off
    LayerMasks masks(scene);
    int number = 0; // of the cell
    const auto look = [&](const PassImages& cell, const FrameAmongOthers& frame, PassRenderer& renderer) -> Status {
        const Image& colour = cell.of(PassTarget::Colour);
        borders.look(colour, frame, renderer);
        if (options.passes.has(Pass::LayerMasks)) {
            return masks.place(sheet, number++, colour, scene.output.supersample, renderer.layers(), task.stop);
        }
        return layers == nullptr ? Status(Done{})
                                 : layers->take(sheet.grid, cell, scene.output.supersample, renderer, task.stop);
    };
    if (Status status = renderSheet(scene, cellFramesOf(scene, options), options.columns, rendered, sheet, look, task);
        !status) {
        return status;
    }
    borders.report(flipbook);
    return Done{};
}

/// Fills the cells of a sheet, and says of the flipbook what was seen.
using CellFill = std::function<Status(PassSheet& sheet, Flipbook& flipbook)>;

/// A flipbook before it is written.
struct MadeFlipbook {
    Flipbook flipbook;
    std::vector<FlipbookFile> files;
};

FileBytes bytesOf(const std::string& text)
{
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

/// @param sheet  may be spent
/// @param colour of its picture, where that is made already
/// @param seen   what was seen of it
Result<MadeFlipbook> finishSheet(const Scene& scene, const FlipbookOptions& options, PassSheet& sheet, FileBytes colour,
    const Flipbook& seen, const std::stop_token& stop)
{
    const std::vector<std::filesystem::path> all = filesOfSheet(options);
    MadeFlipbook made{seen, {}};
    Flipbook& flipbook = made.flipbook;
    flipbook.picture = all.front();
    flipbook.files = static_cast<int>(all.size());
    flipbook.description = all.back();
    flipbook.cellsPerSecond = cellsPerSecond(scene, options);
    flipbook.loops = turnOf(scene.timeline, options).has_value();
    const PassPictures pictures = PassPictures::spending(sheet, renderedPasses(options), options.style);
    Result<std::vector<FileBytes>> bytes = encodePictures(sheet, pictures, scene, options, std::move(colour), stop);
    if (!bytes) {
        return bytes.error();
    }
    std::vector<std::string> texts;
    if (!isOfShares(options)) {
        texts =
            makeEngineFiles(options.engine, engineSheet(scene, options, flipbook, pictures.scales(), bytes.value()));
    }
    texts.push_back(describeFlipbook(scene, options, flipbook, pictures.scales()));
    const std::size_t count = bytes.value().size(); // of pictures
    for (std::size_t i = 0; i < all.size(); ++i) {
        made.files.push_back({all[i], i < count ? std::move(bytes.value()[i]) : bytesOf(texts[i - count])});
    }
    return made;
}

Result<MadeFlipbook> makeTogether(
    const Scene& scene, const FlipbookOptions& options, const CellFill& fill, const std::stop_token& stop)
{
    Flipbook seen;
    PassSheet sheet;
    if (Status status = fill(sheet, seen); !status) {
        return status.error();
    }
    return finishSheet(scene, options, sheet, {}, seen, stop);
}

/// What the sheet of one layer is encoded by: of shares the scene without its background, which belongs to none; of a
/// layer alone with it as the only one.
Scene sceneOfSheet(const Scene& scene, const FlipbookOptions& sheet, std::size_t index)
{
    Scene own = scene;
    if (isShareOfSeveral(sheet)) {
        own.output.background = Background::Transparent;
    } else if (!isOfShares(sheet)) {
        for (std::size_t i = 0; i < own.layers.size(); ++i) {
            own.layers[i].visible = i == index && scene.layers[i].visible;
        }
    }
    return own;
}

/// Makes shares of contributions, where files do not hold these as they are.
/// @return the bytes of their pictures; none: they are encoded as they are
Result<std::vector<FileBytes>> makeShares(const Scene& scene, const FlipbookOptions& options,
    const std::vector<FlipbookOptions>& files, const Image& whole, std::vector<PassSheet>& sheets,
    const std::stop_token& stop)
{
    std::vector<FileBytes> bytes(sheets.size());
    const bool hasFloats = holdsFloats(options.format);
    if (!isShareOfSeveral(files.front()) || (hasFloats && options.layers == LayerOutput::Contribution)) {
        return bytes;
    }
    std::vector<DataImage> colours = layerColours(whole, sheets, scene, *options.layers,
        {options.format, blendSpaceOf(options), !isPremultiplied(files.front()) && !hasFloats});
    for (std::size_t k = 0; k < sheets.size(); ++k) {
        if (hasFloats) {
            sheets[k].targets.of(PassTarget::Colour).pixels = std::move(colours[k].values);
            continue;
        }
        Result<FileBytes> encoded = encodeData(colours[k], options.format, notesOf(files[k]), stop);
        if (!encoded) {
            return encoded.error();
        }
        bytes[k] = std::move(encoded).value();
    }
    return bytes;
}

/// What an engine needs to draw all layers.
void addSharedFiles(
    const Scene& scene, const FlipbookOptions& options, const std::vector<FlipbookOptions>& sheets, MadeFlipbook& all)
{
    const std::vector<std::filesystem::path> paths = sharedFilesOf(options, sheets);
    if (paths.empty()) {
        return;
    }
    EngineSheet sheet = engineSheet(scene, options, all.flipbook, {}, {});
    sheet.named = withEnding(options.output, fileEnding(options.format));
    sheet.isStacked = isShareOfSeveral(sheets.front());
    sheet.space = blendSpaceOf(options);
    for (const FlipbookOptions& each : sheets) {
        const std::filesystem::path picture = picturesOf(each).front();
        const auto file = std::ranges::find(all.files, picture, &FlipbookFile::path);
        sheet.pictures.push_back({Pass::Colour, picture, file->bytes, true, false, each.layer->name});
    }
    const std::vector<std::string> texts = makeEngineFiles(options.engine, sheet);
    for (std::size_t i = 0; i < paths.size(); ++i) {
        all.files.push_back({paths[i], bytesOf(texts[i])});
    }
}

/// A sheet a layer.
Result<MadeFlipbook> makeLayers(const Scene& scene, const FlipbookOptions& options, const ExportTask& task)
{
    const std::vector<WrittenLayer> layers = writtenLayers(scene);
    const std::vector<FlipbookOptions> sheets = sheetsOf(scene, options);
    LayerCells cells(*options.layers, layers.size());
    MadeFlipbook all;
    PassSheet whole;
    if (Status status = renderCells(scene, options, whole, &cells, all.flipbook, task); !status) {
        return status.error();
    }
    Result<std::vector<FileBytes>> colours =
        makeShares(scene, options, sheets, whole.targets.of(PassTarget::Colour), cells.sheets(), task.stop);
    if (!colours) {
        return colours.error();
    }
    whole = {};
    for (std::size_t k = 0; k < layers.size(); ++k) {
        Result<MadeFlipbook> made = finishSheet(sceneOfSheet(scene, sheets[k], layers[k].index), sheets[k],
            cells.sheets()[k], std::move(colours.value()[k]), all.flipbook, task.stop);
        if (!made) {
            return made;
        }
        std::ranges::move(made.value().files, std::back_inserter(all.files));
        cells.sheets()[k] = {};
        const std::filesystem::path picture = k == 0 ? made.value().flipbook.picture : all.flipbook.picture;
        all.flipbook = made.value().flipbook;
        all.flipbook.picture = picture;
    }
    addSharedFiles(scene, options, sheets, all);
    all.flipbook.files = static_cast<int>(all.files.size());
    return all;
}

Result<MadeFlipbook> makeRendered(const Scene& scene, const FlipbookOptions& options, const ExportTask& task)
{
    if (isDivided(options)) {
        return makeLayers(scene, options, task);
    }
    const auto fill = [&](PassSheet& sheet, Flipbook& flipbook) {
        return renderCells(scene, options, sheet, nullptr, flipbook, task);
    };
    return makeTogether(scene, options, fill, task.stop);
}

/// Makes a flipbook, and writes it.
Result<Flipbook> writeFlipbook(
    const Scene& scene, const FlipbookOptions& options, const std::function<Result<MadeFlipbook>()>& make)
{
    if (Status status = checkFlipbook(scene, options); !status) {
        return status.error();
    }
    if (Status status = makeFolderOf(options.output); !status) {
        return status.error();
    }
    const Result<MadeFlipbook> made = make();
    if (!made) {
        return made.error();
    }
    // Folders of an engine only now, so that what is ended before leaves none that are empty.
    std::vector<FileContents> files;
    for (const FlipbookFile& file : made.value().files) {
        if (Status status = makeFolderOf(file.path); !status) {
            return status.error();
        }
        files.push_back({file.path, file.bytes});
    }
    const Status written = writeTogetherAtomically(files);
    return written ? Result<Flipbook>(made.value().flipbook) : written.error();
}

} // namespace

Result<Flipbook> renderFlipbook(const Scene& scene, const FlipbookOptions& options, const ExportTask& task)
{
    return writeFlipbook(scene, options, [&] { return makeRendered(scene, options, task); });
}

Result<std::vector<FlipbookFile>> encodeFlipbook(
    const Scene& scene, const FlipbookOptions& options, const ExportTask& task)
{
    if (Status status = checkFlipbook(scene, options); !status) {
        return status.error();
    }
    Result<MadeFlipbook> made = makeRendered(scene, options, task);
    return made ? Result<std::vector<FlipbookFile>>(std::move(made.value().files)) : made.error();
}

Result<Flipbook> joinFlipbook(
    const Scene& scene, const FlipbookOptions& options, const FrameSource& frames, const Task& task)
{
    if (renderedPasses(options) != PassSet{Pass::Colour} || isDivided(options)) {
        return Error{ErrorCode::OutOfRange, makeMessage("only the colour can be joined of frames"), {},
            makeMessage("Render a flipbook for its other passes")};
    }
    const auto fill = [&](PassSheet& sheet, Flipbook&) {
        return joinSheet(cellFramesOf(scene, options), options.columns, frames,
            {scene.output.width, scene.output.height}, sheet, task);
    };
    return writeFlipbook(scene, options, [&] { return makeTogether(scene, options, fill, task.stop); });
}

} // namespace fumage
