#include "app/cli/command.h"
#include "app/cli/jobs.h"
#include "app/cli/kept_apart.h"
#include "app/cli/picture_options.h"

#include "core/export/jobs/jobs.h"

#include <memory>

namespace fumage::cli {

namespace {

struct RenderArguments {
    PictureOptions picture;
    std::string jobs; ///< file of a list of them, in place of all of the above; empty: none
    bool asJson = false;
};

/// Adds --jobs, which says all that the other options say.
void addJobsTo(CLI::App& command, RenderArguments& arguments)
{
    const std::vector<CLI::Option*> others =
        command.get_options([&](const CLI::Option* option) { return option != command.get_help_ptr(); });
    CLI::Option* jobs = command
                            .add_option("--jobs", arguments.jobs,
                                "Do a list of exports, such as the editor's queue saves: one after the other, also "
                                "after one that fails; - is standard input")
                            ->type_name("FILE");
    for (CLI::Option* other : others) {
        jobs->excludes(other);
    }
    addJson(command, arguments.asJson);
    command.get_option("--json")->needs(jobs);
    command.get_option("preset")->required(false);
}

/// The sheet that carries the preset, once more. What somebody says of passes counts.
Status makeSheetAgain(const RenderArguments& arguments, const FlipbookOptions& sheet, PictureJob& job)
{
    const ExportPlan asked = job.plan;
    takeSheet(sheet, job.plan);
    job.plan.passes = arguments.picture.options.has("passes") ? asked.passes : job.plan.passes;
    job.plan.style.premultiplied =
        arguments.picture.options.has("alpha") ? asked.style.premultiplied : job.plan.style.premultiplied;
    job.plan.recording.skipExisting = false;
    Output& output = job.scene.output;
    if (!arguments.picture.size.empty()) { // it is that of the picture, as everywhere in this command
        if (output.width % sheet.columns != 0 || output.height % sheet.rows != 0) {
            return Error{ErrorCode::OutOfRange,
                makeMessage("a sheet of %1 x %2 cells cannot have %3 x %4 pixels", sheet.columns, sheet.rows,
                    output.width, output.height),
                std::string("--size"), makeMessage("Choose multiples of %1 and %2", sheet.columns, sheet.rows)};
        }
        output.width /= sheet.columns;
        output.height /= sheet.rows;
    }
    report("the preset comes from a sheet of " + std::to_string(sheet.columns) + " x " + std::to_string(sheet.rows)
        + " cells, which is made again; --frames renders frames");
    return Done{};
}

Status renderOne(const RenderArguments& arguments, const NamedPreset& named, JobFiles& written)
{
    Result<PictureJob> job = arguments.picture.jobFor(named, ExportKind::Sequence);
    if (!job) {
        return job.error();
    }
    if (named.shown.sheet && arguments.picture.frames.empty()) {
        if (Status status = makeSheetAgain(arguments, *named.shown.sheet, job.value()); !status) {
            return status;
        }
    }
    if (Status status = keepApart(named.name, job.value().scene, job.value().plan, written); !status) {
        return status;
    }
    const Result<std::optional<Flipbook>> done = writePictures(job.value());
    return done ? Status(Done{}) : done.error();
}

Status render(const RenderArguments& arguments)
{
    if (!arguments.jobs.empty()) {
        return doJobs(arguments.jobs, arguments.asJson);
    }
    JobFiles written;
    return arguments.picture.effect.forEach(
        arguments.picture.output, [&](const NamedPreset& named) { return renderOne(arguments, named, written); });
}

} // namespace

void addRender(CLI::App& program, Action& action)
{
    auto arguments = std::make_shared<RenderArguments>();
    CLI::App* command = program.add_subcommand("render", "Render frames of a preset to numbered pictures");
    arguments->picture.addTo(*command,
        "File to write; #### stands for the frame number, - is standard output (one frame). In a folder, and by "
        "default, the preset's name",
        "Picture size: 512 or 640x360. Default: the preset's",
        "Frames: 7, 0-119 or 0-119:2. Default: the whole timeline; of a picture that carries its preset the frame that "
        "it shows, and a sheet is made again");
    arguments->picture.addFormat(*command);
    arguments->picture.manifest.addTo(*command);
    arguments->picture.options.addTargetsTo(*command);
    arguments->picture.options.addAllTo(*command, ExportKind::Sequence);
    addJobsTo(*command, *arguments);
    command->footer(
        "PNG is sRGB with straight alpha, after exposure and view transform; EXR is linear with premultiplied alpha, "
        "before them: a filmic look is in the PNG only.\n"
        "--passes makes layers of one EXR: sixway_a.R, motion.X (pixels from one picture to the next, right; Y up), "
        "depth.Z (m), normal.X and so on.\n"
        "Examples:\n"
        "  fumage-cli render chimney --frames 40 --output chimney.png\n"
        "  fumage-cli render my.json --frames 0-63 --size 1024 --set look.opacity=8 --output out/smoke_####.exr\n"
        "  fumage-cli render chimney.png --size 2048 --output large.png\n"
        "  fumage-cli render explosion --passes all --output out/boom_####.exr\n"
        "  fumage-cli render --jobs tonight.json");
    command->callback([arguments, &action] {
        if (arguments->jobs.empty() && arguments->picture.effect.presets.empty()) {
            throw CLI::RequiredError("PRESET or --jobs"); // as the library says it, which reads the command line
        }
        action = [arguments] { return render(*arguments); };
    });
}

} // namespace fumage::cli
