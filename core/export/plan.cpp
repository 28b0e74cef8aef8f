#include "core/export/plan.h"

#include "core/base/file.h"
#include "core/export/fit_camera.h"
#include "core/noise/texture.h"

namespace fumage {

namespace {

SequenceOptions sequenceOf(const ExportPlan& plan)
{
    const bool single = plan.kind == ExportKind::Picture;
    return {plan.output, single ? FrameRange{plan.frames.first, plan.frames.first, 1} : plan.frames, plan.format};
}

Status exportNoise(const Effect& effect, const ExportPlan& plan, const std::stop_token& stop)
{
    const int size = plan.noiseSize > 0 ? plan.noiseSize : effect.noise.resolution;
    const Result<NoiseTile> tile = bakeNoise(effect.noise, size, plan.noiseDepth, stop);
    if (!tile) {
        return tile.error();
    }
    const Result<std::vector<std::byte>> bytes = encodeNoise(tile.value(), plan.format);
    return bytes ? writeFileAtomically(plan.output, bytes.value()) : Status(bytes.error());
}

Status exportParticles(const Effect& effect, const ExportPlan& plan, const std::stop_token& stop)
{
    const Result<std::string> text = dumpParticles(effect, plan.frames.first, plan.particles, stop);
    return text ? writeFileAtomically(plan.output, text.value()) : Status(text.error());
}

Result<std::optional<Flipbook>> exportFlipbook(const Effect& effect, const ExportPlan& plan, const SequenceProgress& progress, const std::stop_token& stop)
{
    const Result<Flipbook> flipbook = renderFlipbook(effect, {plan.output, plan.columns, plan.rows, plan.frames, plan.format}, progress, stop);
    return flipbook ? Result<std::optional<Flipbook>>(flipbook.value()) : flipbook.error();
}

} // namespace

bool isPicture(ExportKind kind)
{
    return kind == ExportKind::Sequence || kind == ExportKind::Flipbook || kind == ExportKind::Picture;
}

std::string_view fileEnding(const ExportPlan& plan)
{
    return plan.kind == ExportKind::Particles ? fileEnding(plan.particles) : fileEnding(plan.format);
}

std::filesystem::path firstFile(const ExportPlan& plan)
{
    switch (plan.kind) {
    case ExportKind::Sequence:
    case ExportKind::Picture: return framePath(sequenceOf(plan), plan.frames.first);
    case ExportKind::Flipbook: return withEnding(plan.output, fileEnding(plan.format));
    case ExportKind::NoiseTexture:
    case ExportKind::Particles: break;
    }
    return plan.output;
}

std::filesystem::path lastFile(const ExportPlan& plan)
{
    return plan.kind == ExportKind::Sequence ? framePath(sequenceOf(plan), plan.frames.at(plan.frames.count() - 1)) : firstFile(plan);
}

Result<std::optional<Flipbook>> runExport(const Effect& effect, const ExportPlan& plan, const SequenceProgress& progress, const std::stop_token& stop)
{
    if (plan.fitCamera && isPicture(plan.kind)) {
        const Result<Camera> camera = fitCamera(effect, plan.kind == ExportKind::Flipbook ? plan.frames : framesToFit(effect, plan.frames), progress, stop);
        if (!camera) {
            return camera.error();
        }
        Effect fitted = effect;
        fitted.camera = camera.value();
        ExportPlan rest = plan;
        rest.fitCamera = false;
        return runExport(fitted, rest, progress, stop);
    }
    const auto plainly = [](const Status& status) { return status ? Result<std::optional<Flipbook>>(std::nullopt) : status.error(); };
    switch (plan.kind) {
    case ExportKind::Sequence:
    case ExportKind::Picture: return plainly(renderSequence(effect, sequenceOf(plan), progress, stop));
    case ExportKind::Flipbook: return exportFlipbook(effect, plan, progress, stop);
    case ExportKind::NoiseTexture: return plainly(exportNoise(effect, plan, stop));
    case ExportKind::Particles: return plainly(exportParticles(effect, plan, stop));
    }
    return std::optional<Flipbook>();
}

} // namespace fumage
