#include "core/export/shown.h"

#include "core/export/sheets/sheet_note.h"

namespace fumage {

Shown shownBy(const PresetReading& reading)
{
    return {reading.frame, reading.frame ? readSheetNote(reading.sheet) : std::nullopt};
}

FrameRange framesOf(ExportKind kind, const Timeline& timeline, const Shown& shown)
{
    const bool moves = kind == ExportKind::Flipbook || kind == ExportKind::Video;
    if (shown.sheet && (moves || kind == ExportKind::Sequence)) {
        return shown.sheet->untrimmed.value_or(shown.sheet->frames);
    }
    if (shown.frame && !moves) {
        return {*shown.frame, *shown.frame, 1};
    }
    return {0, timeline.length - 1, 1};
}

void takeSheet(const FlipbookOptions& sheet, ExportPlan& plan)
{
    plan.kind = ExportKind::Flipbook;
    plan.flipbook.columns = sheet.columns;
    plan.flipbook.rows = sheet.rows;
    plan.frames = sheet.untrimmed.value_or(sheet.frames);
    plan.flipbook.trim = sheet.untrimmed.has_value();
    plan.flipbook.retime = sheet.retime;
    plan.passes = sheet.passes;
    plan.style = sheet.style;
    plan.layers = sheet.layers;
    plan.blending = sheet.blending;
    plan.flipbook.packs = sheet.packs;
    plan.flipbook.engine = sheet.engine;
}

} // namespace fumage
