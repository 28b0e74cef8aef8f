#include "core/export/manifest/recorded.h"

#include "core/system/open_file.h"
#include "core/system/path.h"
#include "core/base/text.h"
#include "core/export/manifest/manifest_parts.h"
#include "core/export/manifest/manifest_settings.h"
#include "core/export/output_name.h"
#include "core/export/sheets/flipbook_files.h"
#include "core/image_io/metadata_reader.h"
#include "core/image_io/picture_pixels.h"

#include <optional>

namespace fumage {

namespace {

/// The content of a file, where it is the whole picture of a frame.
std::optional<Content> contentOfFrame(
    const std::filesystem::path& file, const Scene& scene, const SequenceOptions& options, int frame)
{
    const Result<OpenFile> open = OpenFile::open(file);
    if (!open) {
        return {};
    }
    const PartReader parts = [&](std::uint64_t at, std::size_t size) { return open.value().readAt(at, size); };
    const Result<PictureHash> picture = pictureHash(parts);
    const Result<ImageMetadata> notes = readImageMetadata(parts);
    if (!picture || !notes || picture.value().width != scene.output.width
        || picture.value().height != scene.output.height) {
        return {};
    }
    const bool carries = !options.preset.empty() && !notes.value().preset.empty();
    if (carries && (asciiJson(notes.value().preset) != asciiJson(options.preset) || notes.value().frame != frame)) {
        return {};
    }
    return Content{true, picture.value().hash};
}

/// Empty where the job does not say.
std::string settingOf(const ManifestJob& job, const char* key)
{
    const auto found = job.settings.find(key);
    return found == job.settings.end() ? std::string() : found->second;
}

Error cannotBeRendered()
{
    return {ErrorCode::WrongType, makeMessage("what this manifest is of cannot be rendered again"), {},
        makeMessage("Only frames and flipbooks can; of others the files are checked")};
}

ExportPlan planOf(const SequenceOptions& options)
{
    ExportPlan plan;
    plan.kind = ExportKind::Sequence;
    plan.format = options.format;
    plan.passes = options.passes;
    plan.style.premultiplied = options.premultiplied;
    return plan;
}

ExportPlan planOf(const FlipbookOptions& options)
{
    ExportPlan plan;
    plan.kind = ExportKind::Flipbook;
    plan.output = options.output;
    plan.frames = options.frames;
    plan.format = options.format;
    plan.passes = options.passes;
    plan.style = options.style;
    plan.flipbook = {options.columns, options.rows, options.engine, options.packs, false, options.retime};
    plan.layers = options.layers;
    plan.blending = options.blending;
    return plan;
}

} // namespace

ManifestJob jobOf(const Scene& scene, const SequenceOptions& options)
{
    ManifestJob job{std::string(kFramesKind), settingsOf(planOf(options)), scene};
    job.settings["format"] = nameOf(options.format);
    job.settings["step"] = std::to_string(options.frames.step);
    return job;
}

Result<SequenceOptions> sequenceOf(const ManifestJob& job)
{
    const std::optional<ImageFormat> format =
        enumeratorNamed<ImageFormat, kAllImageFormats.size()>(settingOf(job, "format"));
    const Result<FrameRange> step = parseFrameRange("0:" + settingOf(job, "step"));
    if (job.kind != kFramesKind || !format || !step) {
        return cannotBeRendered();
    }
    ExportPlan plan;
    plan.kind = ExportKind::Sequence;
    plan.format = *format;
    if (!readSettings(job.settings, plan) || plan.passes == PassSet()) {
        return cannotBeRendered();
    }
    SequenceOptions options;
    options.format = plan.format;
    options.passes = plan.passes;
    options.premultiplied = plan.style.premultiplied;
    options.frames.step = step.value().step;
    return options;
}

ManifestJob jobOf(const Scene& scene, const FlipbookOptions& options)
{
    ManifestJob job{std::string(kFlipbookKind), settingsOf(planOf(options)), scene};
    job.settings["name"] = options.output.filename().string();
    job.settings["format"] = nameOf(options.format);
    job.settings["frames"] = textOf(options.frames);
    if (options.untrimmed) {
        job.settings["untrimmed"] = textOf(*options.untrimmed);
    }
    return job;
}

Result<FlipbookOptions> flipbookOf(const ManifestJob& job)
{
    const std::optional<ImageFormat> format =
        enumeratorNamed<ImageFormat, kAllImageFormats.size()>(settingOf(job, "format"));
    const Result<FrameRange> frames = parseFrameRange(settingOf(job, "frames"));
    const std::string before = settingOf(job, "untrimmed");
    const Result<FrameRange> untrimmed = before.empty() ? FrameRange() : parseFrameRange(before);
    const std::filesystem::path name = pathFrom(settingOf(job, "name")).filename();
    if (job.kind != kFlipbookKind || !format || !frames || !untrimmed || name.empty()) {
        return cannotBeRendered();
    }
    ExportPlan plan;
    plan.kind = ExportKind::Flipbook;
    plan.output = name;
    plan.frames = frames.value();
    plan.format = *format;
    if (!readSettings(job.settings, plan)) {
        return cannotBeRendered();
    }
    FlipbookOptions options = flipbookOf(plan);
    if (!before.empty()) {
        options.untrimmed = untrimmed.value();
    }
    return options;
}

Result<std::vector<int>> framesThere(const Scene& scene, const SequenceOptions& options,
    const std::function<Status(int frame, const Content& content)>& kept, const std::stop_token& stop)
{
    std::vector<int> there;
    for (const int frame : numbersOf(options)) {
        if (stop.stop_requested()) {
            return Error{ErrorCode::Cancelled, makeMessage("interrupted"), {}, {}};
        }
        const std::optional<Content> content = contentOfFrame(framePath(options, frame), scene, options, frame);
        if (!content) {
            continue;
        }
        if (Status status = kept(frame, *content); !status) {
            return status.error();
        }
        there.push_back(frame);
    }
    return there;
}

Status renderRecorded(const Scene& scene, SequenceOptions options, const Recording& recording, const ExportTask& task)
{
    std::optional<ManifestRecorder> recorder;
    if (!recording.manifest.empty() && !isUtf8(withinFolderOf(recording.manifest, options.output).string())) {
        return nameNotUtf8(options.output);
    }
    if (!recording.manifest.empty()) {
        recorder.emplace(jobOf(scene, options), recording.manifest, options.frames);
        options.written = [&recorder, options](int frame, std::span<const std::byte> bytes) {
            return recorder->add(framePath(options, frame), frame, bytes);
        };
    }
    if (recording.skipExisting) {
        const auto keep = [&](int frame, const Content& content) {
            return recorder ? recorder->add(framePath(options, frame), frame, content) : Status(Done{});
        };
        Result<std::vector<int>> there = framesThere(scene, options, keep, task.stop);
        if (!there) {
            return there.error();
        }
        options.leftOut = std::move(there).value();
    }
    const Status rendered = renderSequence(scene, options, task);
    const Status recorded = recorder ? recorder->write() : Status(Done{});
    return rendered ? recorded : rendered;
}

Status recordNumbered(const ManifestJob& job, const std::filesystem::path& manifest, const NumberedFiles& files,
    const std::function<Status(const FrameSink& written)>& write)
{
    if (manifest.empty()) {
        return write({});
    }
    if (!isUtf8(withinFolderOf(manifest, files.output).string())) {
        return nameNotUtf8(files.output);
    }
    ManifestRecorder recorder(job, manifest, files.frames);
    const Status written = write([&](int frame, std::span<const std::byte> bytes) {
        return recorder.add(framePath(files.output, files.frames, files.ending, frame), frame, bytes);
    });
    const Status recorded = recorder.write();
    return written ? recorded : written;
}

Status recordFlipbook(const Scene& scene, const FlipbookOptions& options, const std::filesystem::path& manifest)
{
    ManifestRecorder recorder(jobOf(scene, options), manifest, std::nullopt);
    for (const std::filesystem::path& file : filesOf(scene, options)) {
        Result<Content> content = contentOfFile(file);
        if (!content) {
            return content.error();
        }
        if (Status status = recorder.add(file, std::nullopt, std::move(content).value()); !status) {
            return status;
        }
    }
    return recorder.write();
}

} // namespace fumage
