#include "app/cli/command.h"
#include "app/cli/kept_apart.h"
#include "app/cli/number_options.h"
#include "app/cli/picture_options.h"
#include "app/cli/progress.h"

#include "core/system/file.h"
#include "core/base/memory.h"
#include "core/system/path.h"
#include "core/base/text.h"
#include "core/export/farm/chunk.h"
#include "core/export/farm/farm.h"
#include "core/export/jobs/jobs.h"
#include "core/export/output_name.h"
#include "core/export/pass_frames.h"
#include "core/export/sheets/flipbook_check.h"
#include "core/preset/preset_file.h"

#include <algorithm>
#include <memory>

namespace fumage::cli {

namespace {

struct FarmOptions {
    PictureOptions picture;
    std::string farm;
    int chunk = 0; ///< 0: chosen
    std::string then;
    std::string grid = "8x8";
};

std::vector<std::string> renderWordsOf(const FarmOptions& options, const Scene& seen, const ExportPlan& plan)
{
    std::vector<std::string> words{"--format", std::string(nameOf(plan.format))};
    for (const char* key : {"passes", "alpha"}) {
        if (options.picture.options.has(key)) {
            words.insert(words.end(), {flagOf(exportOption(key)), std::string(options.picture.options.textOf(key))});
        }
    }
    if (!options.picture.carriesPreset) {
        words.emplace_back("--no-preset");
    }
    if (!options.then.empty() && seen.output.background == Background::Colour) {
        words.insert(words.end(),
            {"--set", "output.background=transparent"}); // joining puts the colour behind the view transform
    }
    return words;
}

std::vector<std::string> joinWordsOf(const FarmOptions& options, const FarmJob& job)
{
    if (options.then.empty()) {
        return {};
    }
    std::vector<std::string> words{
        "join", "./" + presetFileOf(job), "--input", "./" + job.output, "--frames", textOf(job.frames)};
    if (options.then == "flipbook") {
        words.insert(words.end(), {"--grid", options.grid, "--output", "./" + job.name + ".sheet.png"});
    } else {
        words.insert(words.end(), {"--output", "./" + job.name + ".mp4"});
    }
    return words;
}

/// Whether frames can be joined to what is asked for when all machines are done.
Status checkJoin(const FarmOptions& options, const Scene& scene, const ExportPlan& frames)
{
    if (!options.then.empty() && frames.format != ImageFormat::ExrHalf && frames.format != ImageFormat::ExrFloat) {
        return Error{ErrorCode::OutOfRange, makeMessage("frames that are to be joined are EXR"),
            "--then " + options.then, makeMessage("Write --format exr")};
    }
    ExportPlan sheet;
    sheet.kind = ExportKind::Flipbook;
    sheet.output = "sheet.png";
    sheet.frames = frames.frames;
    if (Status status = parseGrid(options.grid, sheet.flipbook.columns, sheet.flipbook.rows); !status) {
        return status;
    }
    return options.then == "flipbook" ? checkFlipbook(scene, flipbookOf(sheet)) : Status(Done{});
}

/// What is asked for, checked as far as it can be before any machine has begun.
Result<PictureJob> planOf(const FarmOptions& options, const NamedPreset& named)
{
    PictureOptions picture = options.picture;
    if (!options.then.empty() && picture.format.empty() && endingOf(pathFrom(picture.output)).empty()) {
        picture.format = nameOf(ImageFormat::ExrHalf);
    }
    // all frames, also of a preset that one picture carries
    Result<PictureJob> job = picture.jobFor(named, ExportKind::Video);
    if (!job) {
        return job;
    }
    ExportPlan& plan = job.value().plan;
    plan.kind = ExportKind::Sequence;
    if (plan.output == kStandardStream) {
        return Error{ErrorCode::OutOfRange, makeMessage("a farm writes no frames to standard output"),
            std::string("--output"), makeMessage("Name a file in a folder that all machines see")};
    }
    if (!isUtf8(std::filesystem::absolute(plan.output).string())) {
        return nameNotUtf8(plan.output);
    }
    const Scene& scene = job.value().scene;
    Status status =
        plan.passes == PassSet{Pass::Colour} ? Status(Done{}) : checkTargets(scene, plan.passes, plan.format);
    status = status ? checkJoin(options, scene, plan) : status;
    if (!status) {
        return status.error();
    }
    return job;
}

FarmJob jobOf(const FarmOptions& options, Farm farm, const Scene& seen, const ExportPlan& plan)
{
    FarmJob job;
    job.folder = std::filesystem::absolute(plan.output).lexically_normal().parent_path();
    job.name = nameWithoutNumber(plan.output);
    job.output = plan.output.filename().string();
    if (!numberPlaceIn(job.output)) {
        job.output = job.name + "_####"
            + std::string(fileEnding(plan.format)); // a task of one frame must not name it otherwise than others do
    }
    job.frames = plan.frames;
    job.perTask = options.chunk > 0 ? std::min(options.chunk, plan.frames.count())
                                    : std::min(framesPerTask(farmCost(seen), plan.frames), mostPerTask(farm));
    job.renderWords = renderWordsOf(options, seen, plan);
    job.joinWords = joinWordsOf(options, job);
    return job;
}

/// Writes the preset as it is to be rendered: with its changes, its size, and the camera that sees all of it.
Status writePreset(const FarmJob& job, const NamedPreset& named, const Scene& seen)
{
    const std::filesystem::path file = job.folder / pathFrom(presetFileOf(job));
    if (isSameFile(file, named.file)) {
        return wouldOverwrite(file);
    }
    Preset preset = named.preset;
    preset.scene = seen;
    if (Status status = makeFolderOf(file); !status) {
        return status;
    }
    return writePresetFile(file, preset);
}

/// Takes the preset's file, the farm's and the frames in among those of the presets before.
Status keepApart(const std::string& preset, const FarmJob& job, const FarmFiles& made, std::string_view ending,
    JobFiles& writtenBefore)
{
    std::vector<std::filesystem::path> files = pathsOf({job.folder / pathFrom(job.output), job.frames, ending, {}});
    files.push_back(job.folder / pathFrom(presetFileOf(job)));
    for (const FarmFile& file : made.files) {
        files.push_back(file.path);
    }
    return writtenBefore.add(preset, files);
}

Status writeOne(const FarmOptions& options, const NamedPreset& named, JobFiles& writtenBefore)
{
    const Result<PictureJob> asked = planOf(options, named);
    if (!asked) {
        return asked.error();
    }
    const ExportPlan& plan = asked.value().plan;
    const Result<Scene> seen =
        withinMemory([&] { return sceneSeenBy(asked.value().scene, plan, ProgressBar("Looking").task()); });
    if (!seen) {
        return seen.error();
    }
    const auto* const farm = std::ranges::find(kAllFarms, options.farm, [](Farm each) { return nameOf(each); });
    const FarmJob job = jobOf(options, *farm, seen.value(), plan);
    const Result<FarmFiles> made = makeFarmFiles(*farm, job);
    if (!made) {
        return made.error();
    }
    if (Status status = keepApart(named.name, job, made.value(), fileEnding(plan.format), writtenBefore); !status) {
        return status;
    }
    if (Status status = writePreset(job, named, seen.value()); !status) {
        return status;
    }
    for (const FarmFile& file : made.value().files) {
        if (Status status = writeFileAtomically(file.path, file.contents); !status) {
            return status;
        }
    }
    report(std::to_string(job.frames.count()) + " frames in " + std::to_string(taskCount(job.frames, job.perTask))
        + " tasks of " + std::to_string(job.perTask));
    return print(made.value().submit + "\n");
}

} // namespace

void addFarm(CLI::App& program, Action& action)
{
    auto options = std::make_shared<FarmOptions>();
    CLI::App* command = program.add_subcommand("farm", "Write what a render farm takes to render frames of a preset");
    options->picture.addTo(*command,
        "Frames to write, in a folder that all machines see; #### stands for the frame number. In a folder, and by "
        "default, the preset's name",
        "Picture size: 512 or 640x360. Default: the preset's");
    options->picture.addFormat(*command);
    options->picture.options.addTargetsTo(*command);
    std::vector<std::string> farms;
    std::ranges::transform(kAllFarms, std::back_inserter(farms), [](Farm each) { return std::string(nameOf(each)); });
    command
        ->add_option("--for", options->farm,
            "What hands out the work: slurm, openjd (Open Job Description), flamenco (3), deadline")
        ->required()
        ->check(CLI::IsMember(farms));
    addWhole(*command, "--chunk", options->chunk, 1, kMaxFrame,
        "Frames a task. Default: so many that machines spend no more on the way to their frames (air, particles) than "
        "on the frames");
    command
        ->add_option(
            "--then", options->then, "When all frames are there, join them: flipbook or video. The frames are EXR then")
        ->check(CLI::IsMember({"flipbook", "video"}));
    command->add_option("--grid", options->grid, "Columns and rows of the flipbook")
        ->type_name("GRID")
        ->capture_default_str();
    command->footer("Beside the frames go the preset as it is to be rendered and the farm's files; how to submit them "
                    "is printed. Tasks leave alone\n"
                    "what is there already and write a manifest: fumage-cli verify FOLDER --frames RANGE says "
                    "afterwards whether all is there.\n"
                    "Examples:\n"
                    "  fumage-cli farm mushroom-cloud --frames 0-119 --for slurm --output "
                    "/mnt/show/smoke/cloud_####.exr --then video\n"
                    "  fumage-cli farm my.json --for openjd --chunk 8 --output frames/");
    command->callback([options, &action] {
        action = [options] {
            JobFiles written;
            return options->picture.effect.forEach(
                options->picture.output, [&](const NamedPreset& named) { return writeOne(*options, named, written); });
        };
    });
}

} // namespace fumage::cli
