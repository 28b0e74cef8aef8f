#include "core/export/plan.h"

#include "core/system/file.h"
#include "core/base/memory.h"
#include "core/base/text.h"
#include "core/export/fit_camera.h"
#include "core/export/manifest/manifest_parts.h"
#include "core/export/output_name.h"
#include "core/export/sheets/cell_frames.h"
#include "core/export/manifest/recorded.h"
#include "core/export/sheets/flipbook_files.h"
#include "core/export/sheets/trim.h"
#include "core/noise/texture.h"
#include "core/preset/preset_file.h"

#include <algorithm>
#include <bit>
#include <span>

namespace fumage {

namespace {

/// A picture is of the first frame alone.
FrameRange framesOf(const ExportPlan& plan)
{
    return plan.kind == ExportKind::Picture ? FrameRange{plan.frames.first, plan.frames.first, 1} : plan.frames;
}

SequenceOptions sequenceOf(const ExportPlan& plan, std::string preset = {})
{
    SequenceOptions options{
        plan.output, framesOf(plan), plan.format, plan.passes, plan.style.premultiplied, std::move(preset)};
    options.isNumbered = plan.kind == ExportKind::Sequence;
    return options;
}

/// The file of a frame.
std::filesystem::path fileOf(const ExportPlan& plan, int frame)
{
    return framePath(plan.output, framesOf(plan), fileEnding(plan), frame);
}

/// The numbers of the frames that are seen in the pictures of a plan, each once. Cells of a flipbook leave frames out;
/// which they show is not known before it has been trimmed.
std::vector<int> framesSeenIn(const ExportPlan& plan)
{
    if (plan.kind != ExportKind::Flipbook || plan.flipbook.trim) {
        return numbersOf(framesOf(plan));
    }
    std::vector<int> frames = framesOfCells(flipbookOf(plan));
    std::sort(frames.begin(), frames.end());
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    return frames;
}

/// The preset that pictures of an effect carry, as JSON.
std::string projectOf(const Scene& scene, const ExportPlan& plan)
{
    if (!plan.project) {
        return {};
    }
    Preset project = *plan.project;
    project.scene = scene;
    return formatCarried(project);
}

Result<std::vector<std::byte>> noiseBytes(const Scene& scene, const ExportPlan& plan, const std::stop_token& stop)
{
    const int size = plan.noise.size > 0 ? plan.noise.size : scene.layers.front().noise.resolution;
    const Result<NoiseTile> tile = bakeNoise(scene.layers.front().noise, size, plan.noise.depth, stop);
    return tile ? encodeNoise(tile.value(), plan.format) : tile.error();
}

Result<std::vector<std::byte>> bytesOf(const Scene& scene, const ExportPlan& plan, const ExportTask& task)
{
    switch (plan.kind) {
    case ExportKind::Sequence:
    case ExportKind::Flipbook:
        if (plan.kind == ExportKind::Flipbook || plan.frames.count() > 1) {
            return Error{ErrorCode::OutOfRange, makeMessage("these are several files"), {},
                makeMessage("Name a file, or one frame")};
        }
        [[fallthrough]];
    case ExportKind::Picture:
        return encodeFrame(scene, plan.frames.first, sequenceOf(plan, projectOf(scene, plan)), task);
    case ExportKind::NoiseTexture: return noiseBytes(scene, plan, task.stop);
    case ExportKind::Video:
    case ExportKind::Particles:
    case ExportKind::Volumes:
    case ExportKind::Air: break;
    }
    return Error{ErrorCode::OutOfRange, makeMessage("this is not written as a stream"), {}, makeMessage("Name a file")};
}

Status writeOne(const Scene& scene, const ExportPlan& plan, const ExportTask& task)
{
    if (Status status = makeFolderOf(plan.output); !status) {
        return status;
    }
    const Result<std::vector<std::byte>> bytes = bytesOf(scene, plan, task);
    return bytes ? writeFileAtomically(plan.output, bytes.value()) : Status(bytes.error());
}

/// @param number 1 or more
int nearestPowerOfTwo(int number)
{
    const auto below = static_cast<std::int64_t>(std::bit_floor(static_cast<unsigned>(number)));
    const std::int64_t wanted = number;
    return static_cast<int>(wanted * wanted < 2 * below * below ? below : 2 * below);
}

/// Whether a plan writes over its source, be it through a link.
bool overwritesSource(const Scene& scene, const ExportPlan& plan)
{
    if (plan.source.empty()) {
        return false;
    }
    const std::vector<std::filesystem::path> files = filesOf(scene, plan);
    return std::any_of(
        files.begin(), files.end(), [&](const std::filesystem::path& file) { return isSameFile(file, plan.source); });
}

Result<std::optional<Flipbook>> exportFlipbook(const Scene& scene, const ExportPlan& plan, const ExportTask& task)
{
    Result<FlipbookOptions> options = flipbookSeenBy(scene, plan, task);
    if (!options) {
        return options.error();
    }
    options.value().preset = projectOf(scene, plan);
    if (const std::filesystem::path& manifest = plan.recording.manifest;
        !manifest.empty() && !isUtf8(withinFolderOf(manifest, plan.output).string())) {
        return nameNotUtf8(plan.output);
    }
    const Result<Flipbook> flipbook = renderFlipbook(scene, options.value(), task);
    if (!flipbook) {
        return flipbook.error();
    }
    const Status recorded = plan.recording.manifest.empty()
        ? Status(Done{})
        : recordFlipbook(scene, options.value(), plan.recording.manifest);
    return recorded ? Result<std::optional<Flipbook>>(flipbook.value()) : recorded.error();
}

} // namespace

std::filesystem::path manifestOf(const ExportPlan& plan)
{
    if (plan.recording.manifest.empty() || !canBeRecorded(plan.kind)) {
        return {};
    }
    return partOf(
        plan.recording.manifest, plan.kind == ExportKind::Flipbook ? std::nullopt : std::optional(framesOf(plan)));
}

std::vector<std::filesystem::path> filesOf(const Scene& scene, const ExportPlan& plan)
{
    if (plan.kind == ExportKind::Flipbook) {
        return filesOf(scene, flipbookOf(plan));
    }
    std::vector<std::filesystem::path> files{firstFile(scene, plan)};
    for (int i = 1; isNumbered(plan.kind) && i < plan.frames.count(); ++i) {
        files.push_back(fileOf(plan, plan.frames.at(i)));
    }
    return files;
}

std::filesystem::path firstFile(const Scene& scene, const ExportPlan& plan)
{
    switch (plan.kind) {
    case ExportKind::Flipbook: return filesOf(scene, plan).front();
    case ExportKind::Video:
    case ExportKind::NoiseTexture: return plan.output;
    case ExportKind::Picture: return withEnding(plan.output, fileEnding(plan));
    default: return fileOf(plan, plan.frames.first);
    }
}

Result<FlipbookOptions> flipbookSeenBy(const Scene& seen, const ExportPlan& plan, const ExportTask& task)
{
    FlipbookOptions options = flipbookOf(plan);
    if (plan.flipbook.trim) {
        const Result<FrameRange> left = trimmed(seen, plan.frames, task);
        if (!left) {
            return left.error();
        }
        options.untrimmed = plan.frames;
        options.frames = left.value();
    }
    return options;
}

std::filesystem::path lastFile(const Scene& scene, const ExportPlan& plan)
{
    return isNumbered(plan.kind) ? fileOf(plan, plan.frames.at(plan.frames.count() - 1)) : firstFile(scene, plan);
}

Result<Output> outputFor(const Scene& scene, const ExportPlan& plan)
{
    Output output = scene.output;
    if (plan.kind != ExportKind::Flipbook || !plan.flipbook.powerOfTwo) {
        return output;
    }
    const auto isPower = [](int number) { return number > 0 && std::has_single_bit(static_cast<unsigned>(number)); };
    if (!isPower(plan.flipbook.columns) || !isPower(plan.flipbook.rows)) {
        return Error{ErrorCode::OutOfRange,
            makeMessage(
                "%1 x %2 cells fill no sheet whose sides are powers of two", plan.flipbook.columns, plan.flipbook.rows),
            {}, makeMessage("Choose columns and rows from 1, 2, 4, 8, 16, 32 and 64")};
    }
    output.width = nearestPowerOfTwo(output.width);
    output.height = nearestPowerOfTwo(output.height);
    return output;
}

Result<Scene> sceneSeenBy(const Scene& scene, const ExportPlan& plan, const ExportTask& task)
{
    Scene out = scene;
    const Result<Output> output = outputFor(scene, plan);
    if (!output) {
        return output.error();
    }
    out.output = output.value();
    if (plan.fitCamera && isPicture(plan.kind)) {
        const Result<Camera> camera = fitCamera(out, framesSeenIn(plan), plan.outlierPercent, task);
        if (!camera) {
            return camera.error();
        }
        out.camera = camera.value();
    }
    return out;
}

namespace {

Result<std::optional<Flipbook>> writeFiles(const Scene& scene, const ExportPlan& plan, const ExportTask& task)
{
    const auto plainly = [](const Status& status) {
        return status ? Result<std::optional<Flipbook>>(std::nullopt) : status.error();
    };
    switch (plan.kind) {
    case ExportKind::Sequence:
    case ExportKind::Picture:
        return plainly(renderRecorded(scene, sequenceOf(plan, projectOf(scene, plan)), plan.recording, task));
    case ExportKind::Flipbook: return exportFlipbook(scene, plan, task);
    case ExportKind::Video: return plainly(renderVideo(scene, videoOf(plan), task));
    case ExportKind::NoiseTexture: return plainly(writeOne(scene, plan, task));
    case ExportKind::Particles:
        return plainly(dumpSequence(
            scene, {plan.output, plan.frames, plan.particles, plan.up.value_or(UpAxis::Y), plan.source}, task));
    case ExportKind::Volumes: {
        const Result<float> voxel = writeVolumes(scene,
            {plan.output, plan.frames, plan.volume.cells, plan.volume.voxel, plan.up.value_or(UpAxis::Z),
                plan.volume.density, plan.source},
            task);
        return plainly(voxel ? Status(Done{}) : Status(voxel.error()));
    }
    case ExportKind::Air: {
        const Result<AirGrid> air = writeAir(scene, {plan.output, plan.frames, plan.air, plan.source}, task);
        return plainly(air ? Status(Done{}) : Status(air.error()));
    }
    }
    return std::optional<Flipbook>();
}

} // namespace

Result<std::optional<Flipbook>> runExport(const Scene& scene, const ExportPlan& plan, const ExportTask& asked)
{
    if (overwritesSource(scene, plan)) {
        return wouldOverwrite(plan.source);
    }
    return withinMemory([&]() -> Result<std::optional<Flipbook>> {
        const ExportTask task = withShelf(asked);
        const Result<Scene> seen = sceneSeenBy(scene, plan, task);
        return seen ? writeFiles(seen.value(), plan, task) : seen.error();
    });
}

Result<std::vector<std::byte>> exportBytes(const Scene& scene, const ExportPlan& plan, const ExportTask& asked)
{
    return withinMemory([&]() -> Result<std::vector<std::byte>> {
        const ExportTask task = withShelf(asked);
        const Result<Scene> seen = sceneSeenBy(scene, plan, task);
        return seen ? bytesOf(seen.value(), plan, task) : seen.error();
    });
}

} // namespace fumage
