#include "core/export/sheets/sheet.h"

#include "core/rendering/view_transform.h"

namespace fumage {

void makeRoom(const SheetGrid& grid, Image& sheet)
{
    const int rows = (grid.cells + grid.columns - 1) / grid.columns;
    sheet.resize(grid.columns * grid.cellWidth, rows * grid.cellHeight);
    for (int number = grid.cells; number < rows * grid.columns; ++number) {
        const SheetCell cell = grid.cell(number);
        for (int y = 0; y < cell.height; ++y) {
            std::fill_n(sheet.row(cell.top + y) + static_cast<std::size_t>(cell.left) * 4,
                static_cast<std::size_t>(cell.width) * 4, 0.0F);
        }
    }
}

namespace {

/// Makes the light of a cell as many stops brighter.
void expose(PassImages& cell, float stops)
{
    if (stops == 0.0F) {
        return;
    }
    const float gain = exposureGain(stops);
    for (const PassTarget target : {PassTarget::Colour, PassTarget::Emission}) {
        auto& pixels = cell.of(target).pixels;
        for (std::size_t i = 0; i + 3 < pixels.size(); i += 4) {
            pixels[i] *= gain;
            pixels[i + 1] *= gain;
            pixels[i + 2] *= gain;
        }
    }
}

} // namespace

void placeCell(const SheetGrid& grid, int number, const Image& cell, Image& sheet)
{
    const SheetCell at = grid.cell(number);
    parallelFor(static_cast<std::size_t>(cell.height), [&](std::size_t row) {
        const int y = static_cast<int>(row);
        std::copy_n(cell.row(y), static_cast<std::size_t>(cell.width) * 4,
            sheet.row(at.top + y) + static_cast<std::size_t>(at.left) * 4);
    });
}

Status renderSheet(const Scene& scene, const CellFrames& frames, int columns, PassSet passes, PassSheet& sheet,
    const CellWatch& watch, const ExportTask& task)
{
    const std::vector<SampledEffect> layers = sampledLayers(scene);
    const int cells = static_cast<int>(frames.numbers.size());
    sheet.grid = {columns, cells, scene.output.width, scene.output.height, frames.turn.has_value()};
    for (std::size_t i = 0; i < kPassTargets; ++i) {
        if (needsTarget(passes, static_cast<PassTarget>(i))) {
            makeRoom(sheet.grid, sheet.targets.targets[i]);
        }
    }
    FrameNeighbours neighbours(layers, frames, passes.has(Pass::Motion), 0, task.shelf);
    PassRenderer renderer;
    PassImages cell;
    const float base = scene.output.exposure;
    for (int number = 0; number < cells; ++number) {
        const Result<FrameAmongOthers> frame = neighbours.at(static_cast<std::size_t>(number), task);
        if (!frame) {
            return frame.error();
        }
        if (Status status =
                renderer.render(frame.value(), sheet.grid.cellWidth, sheet.grid.cellHeight, passes, cell, task.stop);
            !status) {
            return status;
        }
        if (Status status = watch ? watch(cell, frame.value(), renderer) : Status(Done{}); !status) {
            return status;
        }
        // A sheet is shown with one exposure: what changes of it from frame to frame lies in its light.
        expose(cell, scene.atFrame(frames.numbers[static_cast<std::size_t>(number)]).output.exposure - base);
        for (std::size_t i = 0; i < kPassTargets; ++i) {
            placeCell(sheet.grid, number, cell.targets[i], sheet.targets.targets[i]);
        }
        task.progress(ProgressPhase::Frames, number + 1, cells);
    }
    return Done{};
}

Status joinSheet(const CellFrames& frames, int columns, const FrameSource& source, const glm::ivec2& size,
    PassSheet& sheet, const Task& task)
{
    const int cells = static_cast<int>(frames.numbers.size());
    sheet.grid = {columns, cells, size.x, size.y, frames.turn.has_value()};
    Image& whole = sheet.targets.of(PassTarget::Colour);
    makeRoom(sheet.grid, whole);
    Image cell;
    for (int number = 0; number < cells; ++number) {
        if (task.stopped()) {
            return Error{ErrorCode::Cancelled, makeMessage("interrupted"), {}, {}};
        }
        if (Status status = source(frames.numbers[static_cast<std::size_t>(number)], cell); !status) {
            return status;
        }
        placeCell(sheet.grid, number, cell, whole);
        task.progress(ProgressPhase::Frames, number + 1, cells);
    }
    return Done{};
}

} // namespace fumage
