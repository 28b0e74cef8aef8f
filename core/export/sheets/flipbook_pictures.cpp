#include "core/export/sheets/flipbook_pictures.h"

#include "core/base/parallel.h"
#include "core/export/layer_masks.h"
#include "core/export/sheets/cell_frames.h"
#include "core/export/sheets/flipbook_files.h"
#include "core/export/sheets/packing.h"
#include "core/export/sheets/sheet_note.h"

namespace fumage {

namespace {

Result<FileBytes> encodeColour(
    const PassSheet& sheet, const Scene& scene, ImageFormat format, const ImageMetadata& notes)
{
    return encodeSheet(
        sheet.targets.of(PassTarget::Colour), scene, format, sheet.grid.cellWidth, sheet.grid.cellHeight, notes);
}

} // namespace

ImageMetadata notesOf(const FlipbookOptions& sheet)
{
    return {0, sheet.preset, frameOfCell(sheet, 0), sheetNoteOf(sheet)};
}

Result<std::vector<FileBytes>> encodePictures(const PassSheet& sheet, const PassPictures& pictures, const Scene& scene,
    const FlipbookOptions& options, FileBytes colour, const std::stop_token& stop)
{
    const std::vector<Pass> passes = listOf(options.passes);
    const std::vector<std::filesystem::path> files = picturesOf(options);
    const ImageMetadata notes = notesOf(options);
    const Packer packer(sheet, pictures, options.style, scene, options.format);
    std::vector<Result<FileBytes>> encoded(files.size(), FileBytes());
    parallelFor(files.size(), [&](std::size_t i) {
        if (i >= passes.size()) {
            encoded[i] = encodeData(packer.pack(options.packs[i - passes.size()]), options.format, notes, stop);
        } else if (passes[i] == Pass::Colour) {
            encoded[i] = colour.empty() ? encodeColour(sheet, scene, options.format, notes) : std::move(colour);
        } else if (passes[i] == Pass::LayerMasks) {
            encoded[i] = encodeMasks(sheet, options.format, notes, stop);
        } else {
            encoded[i] = encodeData(pictures.picture(passes[i]), options.format, notes, stop);
        }
    });
    std::vector<FileBytes> out;
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
    const PassScales& scales, const std::vector<FileBytes>& bytes)
{
    EngineSheet sheet{
        scene, options.columns, options.rows, flipbook.cellsPerSecond, flipbook.loops, options.style, scales, {}};
    sheet.events = sheetEvents(scene, options);
    if (bytes.empty()) {
        return sheet;
    }
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

} // namespace fumage
