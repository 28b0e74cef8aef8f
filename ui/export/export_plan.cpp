#include "ui/export/export_plan.h"

#include "ui/document/text.h"

#include "core/base/file.h"
#include "core/export/particle_dump.h"
#include "core/noise/texture.h"
#include "core/simulation/simulator.h"

#include <QCoreApplication>

namespace fumage::ui {

namespace {

SequenceOptions optionsOf(const ExportPlan& plan)
{
    SequenceOptions options;
    options.output = plan.path.toStdString();
    options.format = plan.format;
    options.frames = plan.frames;
    if (plan.kind != ExportKind::Sequence && plan.kind != ExportKind::Flipbook) {
        options.frames = {plan.frames.first, plan.frames.first, 1};
    }
    return options;
}

/// The path with its ending; particles and textures have no number.
QString plainPath(const ExportPlan& plan)
{
    const QString ending = endingOf(plan);
    return plan.path.endsWith(ending) ? plan.path : plan.path + ending;
}

Result<QString> exportFlipbook(const Effect& effect, const ExportPlan& plan, const SequenceProgress& progress, const std::stop_token& stop)
{
    FlipbookOptions options;
    options.output = plainPath(plan).toStdString();
    options.columns = plan.columns;
    options.rows = plan.rows;
    options.frames = plan.frames;
    options.format = plan.format;
    const Result<Flipbook> flipbook = renderFlipbook(effect, options, progress, stop);
    if (!flipbook) {
        return flipbook.error();
    }
    return flipbook.value().isCutOff() ? QCoreApplication::translate("ExportPlan", "The smoke is cut off at the edge of cells: move the camera back or make it fade sooner.") : QString();
}

Status exportNoise(const Effect& effect, const ExportPlan& plan, const std::stop_token& stop)
{
    const Result<NoiseTile> tile = bakeNoise(effect.noise, effect.noise.resolution, 0.0F, stop);
    if (!tile) {
        return tile.error();
    }
    const Result<std::vector<std::byte>> bytes = encodeNoise(tile.value(), plan.format);
    return bytes ? writeFileAtomically(plainPath(plan).toStdString(), bytes.value()) : Status(bytes.error());
}

Status exportParticles(const Effect& effect, const ExportPlan& plan, const std::stop_token& stop)
{
    const Result<std::shared_ptr<const Frame>> frame = Simulator(effect).frame(plan.frames.first, stop);
    if (!frame) {
        return frame.error();
    }
    const std::string text = plan.particles == ParticleFormat::Csv ? dumpCsv(*frame.value(), effect) : dumpPly(*frame.value(), effect);
    return writeFileAtomically(plainPath(plan).toStdString(), text);
}

} // namespace

QString endingOf(const ExportPlan& plan)
{
    if (plan.kind == ExportKind::Particles) {
        return plan.particles == ParticleFormat::Csv ? QStringLiteral(".csv") : QStringLiteral(".ply");
    }
    return toQString(fileEnding(plan.format));
}

QString firstFileOf(const ExportPlan& plan)
{
    const bool numbered = plan.kind == ExportKind::Sequence || plan.kind == ExportKind::Picture;
    return numbered ? toQString(framePath(optionsOf(plan), plan.frames.first).string()) : plainPath(plan);
}

QString lastFileOf(const ExportPlan& plan)
{
    const int last = plan.frames.first + (plan.frames.count() - 1) * plan.frames.step;
    return plan.kind == ExportKind::Sequence ? toQString(framePath(optionsOf(plan), last).string()) : firstFileOf(plan);
}

Result<QString> runExport(const Effect& effect, const ExportPlan& plan, const SequenceProgress& progress, const std::stop_token& stop)
{
    const auto silently = [](const Status& status) { return status ? Result<QString>(QString()) : Result<QString>(status.error()); };
    switch (plan.kind) {
    case ExportKind::Sequence:
    case ExportKind::Picture: return silently(renderSequence(effect, optionsOf(plan), progress, stop));
    case ExportKind::Flipbook: return exportFlipbook(effect, plan, progress, stop);
    case ExportKind::NoiseTexture: return silently(exportNoise(effect, plan, stop));
    case ExportKind::Particles: return silently(exportParticles(effect, plan, stop));
    }
    return QString();
}

} // namespace fumage::ui
