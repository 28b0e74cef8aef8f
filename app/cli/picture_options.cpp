#include "app/cli/picture_options.h"

#include "app/cli/number_options.h"
#include "app/cli/progress.h"

#include "core/system/path.h"
#include "core/base/text.h"
#include "core/export/output_name.h"
#include "core/export/remarks.h"

#include <array>
#include <span>

namespace fumage::cli {

namespace {

/// @param rendered frames that were not there already
void tellDone(const Scene& scene, const ExportPlan& plan, const std::optional<Flipbook>& flipbook, int rendered)
{
    const Written written = writtenBy(scene, plan, flipbook);
    const int kept = plan.recording.skipExisting ? written.count - rendered : 0;
    if (kept > 0) {
        report(std::to_string(kept) + " of " + std::to_string(written.count) + " files were there already, "
            + written.first.string() + " to " + written.last.string());
    } else {
        tellWritten(written.count, written.first, written.last);
    }
}

} // namespace

bool parseTwo(const std::string& text, int most, int& first, int& second)
{
    const std::size_t cross = text.find('x');
    const std::optional<std::int64_t> before = parseInteger(text.substr(0, cross));
    const std::optional<std::int64_t> after =
        cross == std::string::npos ? before : parseInteger(text.substr(cross + 1));
    if (!before || !after || *before < 1 || *after < 1 || *before > most || *after > most) {
        return false;
    }
    first = static_cast<int>(*before);
    second = static_cast<int>(*after);
    return true;
}

Status parseGrid(const std::string& text, int& columns, int& rows)
{
    if (!parseTwo(text, kMaxSheetCells, columns, rows)) {
        return Error{ErrorCode::OutOfRange, makeMessage("the grid %1 is not understood", inQuotes(text)),
            std::string("--grid"), makeMessage("Write 8 or 8x4: columns and rows from 1 to %1", kMaxSheetCells)};
    }
    return Done{};
}

Status gridFor(const std::string& asked, const char* usual, const NamedPreset& named, int& columns, int& rows)
{
    if (!asked.empty() || !named.shown.sheet) {
        return parseGrid(asked.empty() ? usual : asked, columns, rows);
    }
    columns = named.shown.sheet->columns;
    rows = named.shown.sheet->rows;
    return Done{};
}

void PictureOptions::addTo(
    CLI::App& command, const std::string& outputHelp, const std::string& sizeHelp, const std::string& framesHelp)
{
    effect.addTo(command);
    command.add_option("-o,--output", output, outputHelp)->type_name("FILE");
    command.add_option("-f,--frame,--frames", frames, framesHelp)->type_name("RANGE");
    command.add_option("--size", size, sizeHelp)->type_name("SIZE");
    command.add_option_function<std::string>(
        "--quality", [this](const std::string& name) { effect.assignments.push_back("output.quality=" + name); },
        "draft, good or final: a quarter of the particles, all, or eight times as many. Default: the preset's");
    addWhole(command, "--supersample", supersample, 1, kMaxSupersample,
        "Render this many times larger and average. Default: the preset's");
    CLI::Option* fit = options.addTo(command, "fit_camera");
    options.addTo(command, "ignore_outliers")->needs(fit);
}

void PictureOptions::addFormat(CLI::App& command)
{
    command.add_flag(
        "!--no-preset", carriesPreset, "Leave the preset out of the pictures, which else open as it; TGA never has it");
    command
        .add_option("--format", format,
            "png (8 bit), png16, exr (half), exr32 (float), tga (8 bit). Default: by the ending of the file")
        ->check(CLI::IsMember({"png", "png16", "exr", "exr32", "tga"}));
}

Result<PictureJob> PictureOptions::jobFor(const NamedPreset& named, ExportKind kind) const
{
    Result<PictureJob> job = jobWithoutOutput(named, kind);
    if (job) {
        if (Status status = chooseOutput(output, format, named.name, job.value().plan); !status) {
            return status.error();
        }
        ExportPlan& plan = job.value().plan;
        if (Status status = options.applyTo(plan); !status) {
            return status.error();
        }
        plan.recording.manifest = manifest.fileFor(plan.output);
    }
    return job;
}

Result<PictureJob> PictureOptions::jobWithoutOutput(const NamedPreset& named, ExportKind kind) const
{
    PictureJob job;
    job.plan.kind = kind;
    job.scene = named.preset.scene;
    job.plan.source = named.file;
    if (!size.empty() && !parseTwo(size, kMaxOutputEdge, job.scene.output.width, job.scene.output.height)) {
        return Error{ErrorCode::OutOfRange, makeMessage("the size %1 is not understood", inQuotes(size)),
            std::string("--size"), makeMessage("Write 512 or 640x360, with edges from 1 to %1", kMaxOutputEdge)};
    }
    if (supersample > 0) {
        job.scene.output.supersample = supersample;
    }
    const Result<FrameRange> range = framesFor(frames, named, kind);
    if (!range) {
        return range.error();
    }
    job.plan.frames = range.value();
    if (carriesPreset) {
        job.plan.project = named.preset;
    }
    return job;
}

Status chooseOutput(const std::string& output, const std::string& formatName, const std::string& name, ExportPlan& plan)
{
    static constexpr std::array<std::string_view, 3> kEndings{".png", ".exr", ".tga"};
    plan.output = pathFrom(output);
    plan.format = enumeratorNamed<ImageFormat, kAllImageFormats.size()>(formatName).value_or(plan.format);
    if (output == kStandardStream) {
        return Done{};
    }
    const std::string_view wanted = fileEnding(plan.format);
    const std::span<const std::string_view> endings =
        formatName.empty() ? std::span<const std::string_view>(kEndings) : std::span(&wanted, 1);
    const Result<std::filesystem::path> path = outputPath(output, {endings, name});
    if (!path) {
        return path.error();
    }
    if (formatName.empty()) {
        plan.format = formatOf(path.value());
    }
    plan.output = withEnding(path.value(), fileEnding(plan.format));
    return Done{};
}

void warnOf(const Scene& scene, const ExportPlan& plan)
{
    for (const Message& remark : remarksOn(scene, plan)) {
        warn(remark.text());
    }
}

Result<std::optional<Flipbook>> writePictures(const PictureJob& job)
{
    if (job.plan.output == kStandardStream) {
        if (talksToOpenJd()) {
            return Error{ErrorCode::OutOfRange,
                makeMessage("standard output cannot have both the picture and what --progress says"), {},
                makeMessage("Name a file")};
        }
        const Result<std::vector<std::byte>> bytes = exportBytes(job.scene, job.plan, ProgressBar("Rendering").task());
        const Status status = bytes ? print(bytes.value()) : Status(bytes.error());
        return status ? Result<std::optional<Flipbook>>(std::nullopt) : status.error();
    }
    warnOf(job.scene, job.plan);
    return exportWithBar(job.scene, job.plan, [&](const Task& task) { return runExport(job.scene, job.plan, task); });
}

Result<std::optional<Flipbook>> exportWithBar(const Scene& scene, const ExportPlan& plan,
    const std::function<Result<std::optional<Flipbook>>(const Task& task)>& run)
{
    int rendered = 0;
    Result<std::optional<Flipbook>> done = std::optional<Flipbook>();
    {
        ProgressBar bar("Rendering");
        const Task shown = bar.task();
        const auto listener = [&](ProgressPhase work, int now, int total) {
            rendered = work == ProgressPhase::Frames ? total : rendered;
            shown.progress(work, now, total);
        };
        done = run({listener, shown.stop});
    }
    if (done) {
        tellDone(scene, plan, done.value(), rendered);
    }
    return done;
}

Written writtenBy(const Scene& scene, const ExportPlan& plan, const std::optional<Flipbook>& flipbook)
{
    if (flipbook) {
        return {flipbook->files, flipbook->picture, flipbook->description};
    }
    return {plan.kind == ExportKind::Sequence ? plan.frames.count() : 1, firstFile(scene, plan), lastFile(scene, plan)};
}

} // namespace fumage::cli
