#include "core/export/export_plan.h"

#include <array>

namespace fumage {

std::string_view nameOf(ExportKind kind)
{
    constexpr std::array<std::string_view, kExportKinds> kNames{
        "sequence", "flipbook", "video", "picture", "noise", "particles", "volumes", "air"};
    return kNames[static_cast<std::size_t>(kind)];
}

bool isPicture(ExportKind kind)
{
    return kind == ExportKind::Sequence || kind == ExportKind::Flipbook || kind == ExportKind::Video
        || kind == ExportKind::Picture;
}

bool isImage(ExportKind kind)
{
    return kind == ExportKind::NoiseTexture || (isPicture(kind) && kind != ExportKind::Video);
}

bool isNumbered(ExportKind kind)
{
    return kind == ExportKind::Sequence || kind == ExportKind::Particles || kind == ExportKind::Volumes
        || kind == ExportKind::Air;
}

bool canBeRecorded(ExportKind kind)
{
    return kind == ExportKind::Sequence || kind == ExportKind::Picture || kind == ExportKind::Flipbook;
}

std::string_view fileEnding(const ExportPlan& plan)
{
    switch (plan.kind) {
    case ExportKind::Video: return fileEnding(plan.video.format);
    case ExportKind::Particles: return fileEnding(plan.particles);
    case ExportKind::Volumes: return kVdbEnding;
    case ExportKind::Air: return fileEnding(plan.air);
    default: return fileEnding(plan.format);
    }
}

FlipbookOptions flipbookOf(const ExportPlan& plan)
{
    FlipbookOptions options{plan.output, plan.flipbook.columns, plan.flipbook.rows, plan.frames, plan.format,
        plan.passes, plan.style, plan.flipbook.engine};
    options.packs = plan.flipbook.packs;
    options.retime = plan.flipbook.retime;
    options.layers = plan.layers;
    options.blending = plan.blending;
    return options;
}

VideoOptions videoOf(const ExportPlan& plan)
{
    return {plan.output, plan.frames, plan.video.format, plan.video.repeat, plan.video.rate};
}

} // namespace fumage
