#include "core/export/manifest/recorded.h"

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/export/manifest/manifest_parts.h"
#include "core/picture_files/picture_notes.h"
#include "core/picture_files/picture_pixels.h"

#include <optional>

namespace fumage {

namespace {

/// The content of a file, where it is the whole picture of a frame.
std::optional<Content> contentOfFrame(const std::filesystem::path& file, const Effect& effect, const SequenceOptions& options, int frame)
{
    const Result<std::string> text = readFile(file, kMaxCheckedBytes);
    if (!text) {
        return {};
    }
    const Result<PictureHash> picture = pictureHash(std::as_bytes(std::span(text.value())));
    const Result<PictureNotes> notes = readPictureNotes(text.value());
    if (!picture || !notes || picture.value().width != effect.output.width || picture.value().height != effect.output.height) {
        return {};
    }
    const bool carries = !options.preset.empty() && !notes.value().preset.empty();
    if (carries && (notes.value().preset != options.preset || notes.value().frame != frame)) {
        return {};
    }
    return Content{true, picture.value().hash};
}

} // namespace

ManifestJob jobOf(const Effect& effect, const SequenceOptions& options)
{
    return {std::string(kFramesKind),
        {{"format", std::string(nameOf(options.format))}, {"passes", textOf(options.passes)}, {"alpha", options.premultiplied ? "premultiplied" : "straight"}, {"step", std::to_string(options.frames.step)}},
        effect};
}

Result<SequenceOptions> sequenceOf(const ManifestJob& job)
{
    const auto setting = [&](const char* key) {
        const auto found = job.settings.find(key);
        return found == job.settings.end() ? std::string() : found->second;
    };
    const std::optional<ImageFormat> format = enumeratorNamed<ImageFormat, kAllImageFormats.size()>(setting("format"));
    const Result<FrameRange> step = parseFrameRange("0:" + setting("step"));
    const Result<PassSet> passes = parsePasses(setting("passes"));
    if (job.kind != kFramesKind || !format || !step || !passes || passes.value() == PassSet()) {
        return Error{ErrorCode::WrongType, said("what this manifest is of cannot be rendered again"), {}, said("Only frames can; of others the files are checked")};
    }
    SequenceOptions options;
    options.format = *format;
    options.passes = passes.value();
    options.premultiplied = setting("alpha") == "premultiplied";
    options.frames.step = step.value().step;
    return options;
}

Result<std::vector<int>> framesThere(const Effect& effect, const SequenceOptions& options, const std::function<Status(int frame, const Content& content)>& kept, const std::stop_token& stop)
{
    std::vector<int> there;
    for (const int frame : numbersOf(options)) {
        if (stop.stop_requested()) {
            return Error{ErrorCode::Cancelled, said("interrupted"), {}, {}};
        }
        const std::optional<Content> content = contentOfFrame(framePath(options, frame), effect, options, frame);
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

Status renderRecorded(const Effect& effect, SequenceOptions options, const Recording& recording, const Progress& progress, const std::stop_token& stop)
{
    std::optional<ManifestRecorder> recorder;
    if (!recording.manifest.empty()) {
        recorder.emplace(jobOf(effect, options), recording.manifest, options.frames);
        options.written = [&recorder, options](int frame, std::span<const std::byte> bytes) { return recorder->add(framePath(options, frame), frame, bytes); };
    }
    if (recording.skipExisting) {
        const auto keep = [&](int frame, const Content& content) { return recorder ? recorder->add(framePath(options, frame), frame, content) : Status(Done{}); };
        Result<std::vector<int>> there = framesThere(effect, options, keep, stop);
        if (!there) {
            return there.error();
        }
        options.leftOut = std::move(there).value();
    }
    const Status rendered = renderSequence(effect, options, progress, stop);
    const Status recorded = recorder ? recorder->write() : Status(Done{});
    return rendered ? recorded : rendered;
}

Status recordNumbered(const ManifestJob& job, const std::filesystem::path& manifest, const NumberedFiles& files, const std::function<Status(const FrameSink& written)>& write)
{
    if (manifest.empty()) {
        return write({});
    }
    ManifestRecorder recorder(job, manifest, files.frames);
    const Status written = write([&](int frame, std::span<const std::byte> bytes) { return recorder.add(framePath(files.output, files.frames, files.ending, frame), frame, bytes); });
    const Status recorded = recorder.write();
    return written ? recorded : written;
}

Status recordFlipbook(const Effect& effect, const FlipbookOptions& options, const std::filesystem::path& manifest)
{
    const std::string grid = std::to_string(options.columns) + "x" + std::to_string(options.rows);
    ManifestJob job{"flipbook", {{"format", std::string(nameOf(options.format))}, {"passes", textOf(options.passes)}, {"grid", grid}, {"for", std::string(nameOf(options.engine))}}, effect};
    ManifestRecorder recorder(std::move(job), manifest, std::nullopt);
    for (const std::filesystem::path& file : filesOf(options)) {
        const Result<std::string> bytes = readFile(file, kMaxCheckedBytes);
        if (!bytes) {
            return bytes.error();
        }
        if (Status status = recorder.add(file, std::nullopt, std::as_bytes(std::span(bytes.value()))); !status) {
            return status;
        }
    }
    return recorder.write();
}

} // namespace fumage
