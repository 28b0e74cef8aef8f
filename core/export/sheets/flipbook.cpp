#include "core/export/sheets/flipbook.h"

#include "core/system/file.h"
#include "core/base/parallel.h"
#include "core/system/path.h"
#include "core/base/text.h"
#include "core/export/sheets/cell_frames.h"
#include "core/export/engines/engine_files.h"
#include "core/export/sheets/flipbook_description.h"
#include "core/export/sheets/flipbook_files.h"
#include "core/export/loop.h"
#include "core/export/output_name.h"
#include "core/export/sheets/sheet.h"
#include "core/export/sheets/sheet_note.h"
#include "core/rendering/framing.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <iterator>

namespace fumage {

namespace {

/// How many targets passes keep in memory until all cells are there.
std::int64_t targetsOf(PassSet passes)
{
    std::int64_t count = 0;
    for (std::size_t i = 0; i < kPassTargets; ++i) {
        count += needsTarget(passes, static_cast<PassTarget>(i)) ? 1 : 0;
    }
    return count;
}

Status check(const Scene& scene, const FlipbookOptions& options)
{
    const auto inRange = [](int count) { return count >= 1 && count <= kMaxSheetCells; };
    if (!inRange(options.columns) || !inRange(options.rows)) {
        return Error{ErrorCode::OutOfRange, makeMessage("a flipbook of %1 x %2 cells", options.columns, options.rows),
            {}, makeMessage("Use 1 to %1 columns and rows", kMaxSheetCells)};
    }
    if (const std::string name = options.output.filename().string(); !isUtf8(name)) {
        return nameNotUtf8(options.output);
    }
    if (Status status = checkEngine(options.engine, options.passes, options.format); !status) {
        return status;
    }
    if (Status status = checkPacks(options.packs, scene.output.width, scene.output.height); !status) {
        return status;
    }
    if (options.passes == PassSet() && options.packs.empty()) {
        return Error{ErrorCode::OutOfRange, makeMessage("no pass is asked for"), {},
            makeMessage("Choose one, or a packed picture")};
    }
    const int cells = options.columns * options.rows;
    if (options.frames.count() < cells) {
        const auto [columns, rows] = gridWithin(options.frames.count(), options.columns, options.rows);
        return Error{ErrorCode::OutOfRange,
            makeMessage("%1 frames do not fill %2 cells", options.frames.count(), cells), {},
            makeMessage("Choose more frames or fewer columns and rows, such as %1x%2", columns, rows)};
    }
    const std::int64_t width = static_cast<std::int64_t>(scene.output.width) * options.columns;
    const std::int64_t height = static_cast<std::int64_t>(scene.output.height) * options.rows;
    const std::int64_t pixels = width * height;
    const bool isTooLong = width > kMaxSheetEdge || height > kMaxSheetEdge;
    const std::int64_t targetPixels = pixels * targetsOf(renderedPasses(options));
    if (isTooLong || pixels > static_cast<std::int64_t>(kMaxSheetPixels)
        || targetPixels > static_cast<std::int64_t>(kMaxTargetPixels)) {
        return Error{ErrorCode::TooLarge, makeMessage("a flipbook of %1 x %2 pixels", width, height), {},
            makeMessage("Choose smaller or fewer cells: edges up to %1 pixels, at most %2 million in all",
                kMaxSheetEdge, kMaxSheetPixels >> 20U)};
    }
    return Done{};
}

float maxBorderAlpha(const Image& cell)
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

/// Looks for smoke on the borders of cells with a transparent background.
class BorderWatch {
public:
    explicit BorderWatch(const Scene& scene)
        : m_scene(scene)
        , m_framing(scene.camera, scene.output.width, scene.output.height)
    {
    }

    void look(const Image& cell, const FrameAmongOthers& frames, const PassRenderer& renderer)
    {
        if (m_scene.output.background != Background::Transparent) {
            return;
        }
        const Frame& frame = *frames.layers.front().now;
        for (std::size_t layer = 0; layer < frames.layers.size(); ++layer) {
            m_framing.addParticles(frames.layers[layer].now->particles, renderer.appearance(layer),
                secondsOf(m_scene.timeline, frame.number));
        }
        const float alpha = maxBorderAlpha(cell);
        m_alpha = std::max(m_alpha, alpha);
        constexpr float kSeen = 1.0F / 255.0F;
        if (alpha < kSeen) {
            return;
        }
        const PictureReach reach = reachOf(cell, kSeen);
        if (!m_cutOff) {
            m_cutOff = CutOff{.firstFrame = frame.number, .lastFrame = frame.number};
        }
        m_cutOff->firstFrame = std::min(m_cutOff->firstFrame, frame.number);
        m_cutOff->lastFrame = std::max(m_cutOff->lastFrame, frame.number);
        m_cutOff->left |= reach.left == 0;
        m_cutOff->top |= reach.top == 0;
        m_cutOff->right |= reach.right == cell.width;
        m_cutOff->bottom |= reach.bottom == cell.height;
    }

    /// Writes down what was seen.
    void report(Flipbook& flipbook) const
    {
        flipbook.edgeAlpha = m_alpha;
        flipbook.cutOff = m_cutOff;
        if (m_cutOff && m_scene.camera.mode == CameraMode::Orbit) {
            flipbook.cutOff->distance = m_framing.distanceFrom(m_scene.camera.target);
        }
    }

private:
    const Scene& m_scene;
    Framing m_framing;
    float m_alpha = 0.0F;
    std::optional<CutOff> m_cutOff;
};

/// Renders the cells into the sheet, and says of the flipbook whether they hold all smoke.
Status renderCells(
    const Scene& scene, const FlipbookOptions& options, PassSheet& sheet, Flipbook& flipbook, const Task& task)
{
    BorderWatch borders(scene);
    PassSet rendered = renderedPasses(options);
    rendered.add(Pass::Alpha); // it tells what is cut off
    const auto look = [&](const PassImages& cell, const FrameAmongOthers& frame, const PassRenderer& renderer) {
        borders.look(cell.of(PassTarget::Colour), frame, renderer);
    };
    if (Status status = renderSheet(scene, cellFramesOf(scene, options), options.columns, rendered, sheet, look, task);
        !status) {
        return status;
    }
    borders.report(flipbook);
    return Done{};
}

Result<std::vector<std::byte>> encodeColour(
    const PassSheet& sheet, const Scene& scene, ImageFormat format, const ImageMetadata& notes)
{
    return encodeSheet(
        sheet.targets.of(PassTarget::Colour), scene, format, sheet.grid.cellWidth, sheet.grid.cellHeight, notes);
}

/// The bytes of all pictures, each on a thread of its own.
Result<std::vector<std::vector<std::byte>>> encodePictures(const PassSheet& sheet, const PassPictures& pictures,
    const Scene& scene, const FlipbookOptions& options, const std::stop_token& stop)
{
    const std::vector<Pass> passes = listOf(options.passes);
    const std::vector<std::filesystem::path> files = picturesOf(options);
    const ImageMetadata notes{0, options.preset, frameOfCell(options, 0), sheetNoteOf(options)};
    const Packer packer(sheet, pictures, options.style, scene, options.format);
    std::vector<Result<std::vector<std::byte>>> encoded(files.size(), std::vector<std::byte>());
    parallelFor(files.size(), [&](std::size_t i) {
        if (i >= passes.size()) {
            encoded[i] = encodeData(packer.pack(options.packs[i - passes.size()]), options.format, notes, stop);
        } else if (passes[i] == Pass::Colour) {
            encoded[i] = encodeColour(sheet, scene, options.format, notes);
        } else {
            encoded[i] = encodeData(pictures.picture(passes[i]), options.format, notes, stop);
        }
    });
    std::vector<std::vector<std::byte>> out;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (!encoded[i]) {
            Error error = encoded[i].error();
            error.place = files[i].string();
            return error;
        }
        out.push_back(std::move(encoded[i]).value());
    }
    return out;
}

EngineSheet engineSheet(const Scene& scene, const FlipbookOptions& options, const Flipbook& flipbook,
    const PassScales& scales, const std::vector<std::vector<std::byte>>& bytes)
{
    EngineSheet sheet{
        scene, options.columns, options.rows, flipbook.cellsPerSecond, flipbook.loops, options.style, scales, {}};
    const std::vector<Pass> passes = listOf(options.passes);
    const std::vector<std::filesystem::path> files = picturesOf(options);
    const auto areVectors = [](Pass pass) { return pass == Pass::Motion || pass == Pass::Normal; };
    for (std::size_t i = 0; i < passes.size(); ++i) {
        sheet.pictures.push_back({passes[i], files[i], bytes[i], passes[i] == Pass::Colour, areVectors(passes[i])});
    }
    for (std::size_t i = passes.size(); i < files.size(); ++i) {
        const PackedPicture& pack = options.packs[i - passes.size()];
        const PassSet packed = passesOf(std::span(&pack, 1));
        sheet.pictures.push_back(
            {{}, files[i], bytes[i], isSrgb(pack, options.format), packed.hasAny({Pass::Motion, Pass::Normal})});
    }
    return sheet;
}

/// Fills the cells of a sheet, and says of the flipbook what was seen.
using CellFill = std::function<Status(PassSheet& sheet, Flipbook& flipbook)>;

/// A flipbook before it is written.
struct MadeFlipbook {
    Flipbook flipbook;
    std::vector<FlipbookFile> files;
};

std::vector<std::byte> bytesOf(const std::string& text)
{
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

/// @param all filesOf() the options
Result<MadeFlipbook> makeFlipbook(const Scene& scene, const FlipbookOptions& options,
    const std::vector<std::filesystem::path>& all, const CellFill& fill, const std::stop_token& stop)
{
    MadeFlipbook made;
    Flipbook& flipbook = made.flipbook;
    flipbook.picture = all.front();
    flipbook.files = static_cast<int>(all.size());
    flipbook.description = all.back();
    flipbook.cellsPerSecond = cellsPerSecond(scene, options);
    flipbook.loops = turnOf(scene.timeline, options).has_value();
    PassSheet sheet;
    if (Status status = fill(sheet, flipbook); !status) {
        return status.error();
    }
    const PassPictures pictures = PassPictures::spending(sheet, renderedPasses(options), options.style);
    Result<std::vector<std::vector<std::byte>>> bytes = encodePictures(sheet, pictures, scene, options, stop);
    if (!bytes) {
        return bytes.error();
    }
    std::vector<std::string> texts =
        makeEngineFiles(options.engine, engineSheet(scene, options, flipbook, pictures.scales(), bytes.value()));
    texts.push_back(describeFlipbook(scene, options, flipbook, pictures.scales()));
    const std::size_t count = bytes.value().size(); // of pictures
    for (std::size_t i = 0; i < all.size(); ++i) {
        made.files.push_back({all[i], i < count ? std::move(bytes.value()[i]) : bytesOf(texts[i - count])});
    }
    return made;
}

Result<Flipbook> writeFlipbook(
    const Scene& scene, const FlipbookOptions& options, const CellFill& fill, const std::stop_token& stop)
{
    if (Status status = check(scene, options); !status) {
        return status.error();
    }
    const std::vector<std::filesystem::path> all = filesOf(options);
    if (Status status = makeFolderOf(options.output); !status) {
        return status.error();
    }
    const Result<MadeFlipbook> made = makeFlipbook(scene, options, all, fill, stop);
    if (!made) {
        return made.error();
    }
    // Folders of an engine only now, so that what is ended before leaves none that are empty.
    for (const std::filesystem::path& file : all) {
        if (Status status = makeFolderOf(file); !status) {
            return status.error();
        }
    }
    std::vector<FileContents> files;
    for (const FlipbookFile& file : made.value().files) {
        files.push_back({file.path, file.bytes});
    }
    const Status written = writeTogetherAtomically(files);
    return written ? Result<Flipbook>(made.value().flipbook) : written.error();
}

} // namespace

Result<Flipbook> renderFlipbook(const Scene& scene, const FlipbookOptions& options, const Task& task)
{
    const auto fill = [&](PassSheet& sheet, Flipbook& flipbook) {
        return renderCells(scene, options, sheet, flipbook, task);
    };
    return writeFlipbook(scene, options, fill, task.stop);
}

Result<std::vector<FlipbookFile>> encodeFlipbook(const Scene& scene, const FlipbookOptions& options, const Task& task)
{
    if (Status status = check(scene, options); !status) {
        return status.error();
    }
    const auto fill = [&](PassSheet& sheet, Flipbook& flipbook) {
        return renderCells(scene, options, sheet, flipbook, task);
    };
    Result<MadeFlipbook> made = makeFlipbook(scene, options, filesOf(options), fill, task.stop);
    return made ? Result<std::vector<FlipbookFile>>(std::move(made.value().files)) : made.error();
}

Result<Flipbook> joinFlipbook(
    const Scene& scene, const FlipbookOptions& options, const FrameSource& frames, const Task& task)
{
    if (renderedPasses(options) != PassSet{Pass::Colour}) {
        return Error{ErrorCode::OutOfRange, makeMessage("only the colour can be joined of frames"), {},
            makeMessage("Render a flipbook for its other passes")};
    }
    const auto fill = [&](PassSheet& sheet, Flipbook&) {
        return joinSheet(cellFramesOf(scene, options), options.columns, frames,
            {scene.output.width, scene.output.height}, sheet, task);
    };
    return writeFlipbook(scene, options, fill, task.stop);
}

} // namespace fumage
