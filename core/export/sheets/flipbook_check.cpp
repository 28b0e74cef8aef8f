#include "core/export/sheets/flipbook_check.h"

#include "core/base/text.h"
#include "core/export/engines/engine_files.h"
#include "core/export/layer_masks.h"
#include "core/export/output_name.h"
#include "core/export/sheets/flipbook_files.h"

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

} // namespace

Status checkLayers(const FlipbookOptions& options)
{
    if (isDivided(options) && options.passes.has(Pass::LayerMasks)) {
        return Error{ErrorCode::OutOfRange,
            makeMessage("layers that are written as %1 have no masks of layers", nameOf(*options.layers)), {},
            makeMessage("Write layers together, or the alpha of contributions")};
    }
    if (!isOfShares(options)) {
        return Done{};
    }
    PassSet most{Pass::Colour};
    if (options.layers == LayerOutput::Contribution) {
        most.add(Pass::Alpha);
    }
    PassSet all = most;
    all.add(renderedPasses(options));
    if (all != most || !options.packs.empty()) {
        return Error{ErrorCode::OutOfRange,
            makeMessage(
                "layers that are written as %1 have no other passes than %2", nameOf(*options.layers), textOf(most)),
            {}, makeMessage("Choose these passes, or layers alone")};
    }
    const bool isPlayed = options.layers == LayerOutput::Stacked && stacksLayers(options.engine);
    if (options.engine != Engine::Generic && !isPlayed) {
        return Error{ErrorCode::OutOfRange,
            makeMessage("what is written for %1 plays one sheet", titleOf(options.engine)), {},
            makeMessage("Choose another engine or none, or layers together or alone")};
    }
    return Done{};
}

Status checkFlipbook(const Scene& scene, const FlipbookOptions& options)
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
    if (Status status = checkLayers(options); !status) {
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
    const auto sheets = static_cast<std::int64_t>(isDivided(options) ? 1 + writtenLayers(scene).size() : 1);
    const bool hasMasks = options.passes.has(Pass::LayerMasks);
    if (Status status = hasMasks ? checkMasks(scene, options.format, pixels, 0) : Status(Done{}); !status) {
        return status;
    }
    const std::int64_t targetPixels = pixels * targetsOf(renderedPasses(options)) * sheets;
    if (isTooLong || pixels > static_cast<std::int64_t>(kMaxSheetPixels)
        || targetPixels > static_cast<std::int64_t>(kMaxTargetPixels)) {
        return Error{ErrorCode::TooLarge, makeMessage("a flipbook of %1 x %2 pixels", width, height), {},
            makeMessage("Choose smaller or fewer cells: edges up to %1 pixels, at most %2 million in all",
                kMaxSheetEdge, kMaxSheetPixels >> 20U)};
    }
    return Done{};
}

} // namespace fumage
