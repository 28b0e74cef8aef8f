#include "core/export/sheets/flipbook_files.h"
#include "core/export/manifest/recorded.h"

#include "core/base/open_file.h"
#include "core/base/path.h"
#include "core/base/text.h"
#include "core/export/sheets/cell_frames.h"
#include "core/export/manifest/manifest_parts.h"
#include "core/export/output_name.h"
#include "core/image_io/metadata_reader.h"
#include "core/image_io/picture_pixels.h"

#include <optional>
#include <sstream>

namespace fumage {

namespace {

/// The content of a file, where it is the whole picture of a frame.
std::optional<Content> contentOfFrame(
    const std::filesystem::path& file, const Effect& effect, const SequenceOptions& options, int frame)
{
    const Result<OpenFile> open = OpenFile::open(file);
    if (!open) {
        return {};
    }
    const PartReader parts = [&](std::uint64_t at, std::size_t size) { return open.value().readAt(at, size); };
    const Result<PictureHash> picture = pictureHash(parts);
    const Result<ImageMetadata> notes = readImageMetadata(parts);
    if (!picture || !notes || picture.value().width != effect.output.width
        || picture.value().height != effect.output.height) {
        return {};
    }
    const bool carries = !options.preset.empty() && !notes.value().preset.empty();
    if (carries && (asciiJson(notes.value().preset) != asciiJson(options.preset) || notes.value().frame != frame)) {
        return {};
    }
    return Content{true, picture.value().hash};
}

constexpr const char* kPremultiplied = "premultiplied";
constexpr char kBetweenPacks = ';'; // no name of one has it

std::string alphaOf(bool premultiplied)
{
    return premultiplied ? kPremultiplied : "straight";
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

/// What a flipbook is packed and played as; each is as on the command line.
/// @error that of the first that is not understood
Status readExtras(const ManifestJob& job, FlipbookOptions& options)
{
    std::istringstream packs(settingOf(job, "packs"));
    for (std::string text; std::getline(packs, text, kBetweenPacks);) {
        Result<PackedPicture> pack = parsePack(text);
        if (!pack) {
            return pack.error();
        }
        options.packs.push_back(std::move(pack).value());
    }
    if (const std::string text = settingOf(job, "retime"); !text.empty()) {
        Result<Curve> retime = parseRetime(text);
        if (!retime) {
            return retime.error();
        }
        options.retime = std::move(retime).value();
    }
    if (const std::string text = settingOf(job, "untrimmed"); !text.empty()) {
        const Result<FrameRange> untrimmed = parseFrameRange(text);
        if (!untrimmed) {
            return untrimmed.error();
        }
        options.untrimmed = untrimmed.value();
    }
    return Done{};
}

} // namespace

ManifestJob jobOf(const Effect& effect, const SequenceOptions& options)
{
    return {std::string(kFramesKind),
        {{"format", std::string(nameOf(options.format))}, {"passes", textOf(options.passes)},
            {"alpha", alphaOf(options.premultiplied)}, {"step", std::to_string(options.frames.step)}},
        effect};
}

Result<SequenceOptions> sequenceOf(const ManifestJob& job)
{
    const std::optional<ImageFormat> format =
        enumeratorNamed<ImageFormat, kAllImageFormats.size()>(settingOf(job, "format"));
    const Result<FrameRange> step = parseFrameRange("0:" + settingOf(job, "step"));
    const Result<PassSet> passes = parsePasses(settingOf(job, "passes"));
    if (job.kind != kFramesKind || !format || !step || !passes || passes.value() == PassSet()) {
        return cannotBeRendered();
    }
    SequenceOptions options;
    options.format = *format;
    options.passes = passes.value();
    options.premultiplied = settingOf(job, "alpha") == kPremultiplied;
    options.frames.step = step.value().step;
    return options;
}

ManifestJob jobOf(const Effect& effect, const FlipbookOptions& options)
{
    ManifestJob job{std::string(kFlipbookKind),
        {{"name", options.output.filename().string()}, {"format", std::string(nameOf(options.format))},
            {"passes", textOf(options.passes)}, {"columns", std::to_string(options.columns)},
            {"rows", std::to_string(options.rows)}, {"frames", textOf(options.frames)},
            {"for", std::string(nameOf(options.engine))}, {"layout", std::string(nameOf(options.style.layout))},
            {"vectors", std::string(nameOf(options.style.vectors))},
            {"normals", std::string(nameOf(options.style.normals))}, {"alpha", alphaOf(options.style.premultiplied)}},
        effect};
    std::string packs;
    for (const PackedPicture& pack : options.packs) {
        packs += (packs.empty() ? "" : std::string(1, kBetweenPacks)) + textOf(pack);
    }
    if (!packs.empty()) {
        job.settings["packs"] = packs;
    }
    if (options.retime) {
        job.settings["retime"] = textOfRetime(*options.retime);
    }
    if (options.untrimmed) {
        job.settings["untrimmed"] = textOf(*options.untrimmed);
    }
    return job;
}

Result<FlipbookOptions> flipbookOf(const ManifestJob& job)
{
    const std::optional<ImageFormat> format =
        enumeratorNamed<ImageFormat, kAllImageFormats.size()>(settingOf(job, "format"));
    const std::optional<Engine> engine = enumeratorNamed<Engine, kEngines>(settingOf(job, "for"));
    const std::optional<SixWayLayout> layout = enumeratorNamed<SixWayLayout, kSixWayLayouts>(settingOf(job, "layout"));
    const std::optional<VectorSigns> vectors = enumeratorNamed<VectorSigns, kVectorSigns>(settingOf(job, "vectors"));
    const std::string told =
        settingOf(job, "normals"); // manifests of before there was a choice say nothing: green was up
    const std::optional<NormalGreen> normals =
        told.empty() ? NormalGreen::OpenGl : enumeratorNamed<NormalGreen, kNormalGreens>(told);
    const Result<PassSet> passes = parsePasses(settingOf(job, "passes"));
    const Result<FrameRange> frames = parseFrameRange(settingOf(job, "frames"));
    const std::optional<std::int64_t> columns = parseInteger(settingOf(job, "columns"));
    const std::optional<std::int64_t> rows = parseInteger(settingOf(job, "rows"));
    const auto areCells = [](const std::optional<std::int64_t>& count) {
        return count && *count >= 1 && *count <= kMaxSheetCells;
    };
    const std::filesystem::path name = pathFrom(settingOf(job, "name")).filename();
    if (job.kind != kFlipbookKind || !format || !engine || !layout || !vectors || !normals || !passes || !frames
        || !areCells(columns) || !areCells(rows) || name.empty()) {
        return cannotBeRendered();
    }
    FlipbookOptions options{name, static_cast<int>(*columns), static_cast<int>(*rows), frames.value(), *format,
        passes.value(), {*layout, *vectors, settingOf(job, "alpha") == kPremultiplied, *normals}, *engine};
    if (!readExtras(job, options)) {
        return cannotBeRendered();
    }
    return options;
}

Result<std::vector<int>> framesThere(const Effect& effect, const SequenceOptions& options,
    const std::function<Status(int frame, const Content& content)>& kept, const std::stop_token& stop)
{
    std::vector<int> there;
    for (const int frame : numbersOf(options)) {
        if (stop.stop_requested()) {
            return Error{ErrorCode::Cancelled, makeMessage("interrupted"), {}, {}};
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

Status renderRecorded(const Effect& effect, SequenceOptions options, const Recording& recording,
    const Progress& progress, const std::stop_token& stop)
{
    std::optional<ManifestRecorder> recorder;
    if (!recording.manifest.empty() && !isUtf8(withinFolderOf(recording.manifest, options.output).string())) {
        return nameNotUtf8(options.output);
    }
    if (!recording.manifest.empty()) {
        recorder.emplace(jobOf(effect, options), recording.manifest, options.frames);
        options.written = [&recorder, options](int frame, std::span<const std::byte> bytes) {
            return recorder->add(framePath(options, frame), frame, bytes);
        };
    }
    if (recording.skipExisting) {
        const auto keep = [&](int frame, const Content& content) {
            return recorder ? recorder->add(framePath(options, frame), frame, content) : Status(Done{});
        };
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

Status recordFlipbook(const Effect& effect, const FlipbookOptions& options, const std::filesystem::path& manifest)
{
    ManifestRecorder recorder(jobOf(effect, options), manifest, std::nullopt);
    for (const std::filesystem::path& file : filesOf(options)) {
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
