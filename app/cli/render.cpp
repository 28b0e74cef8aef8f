#include "app/cli/command.h"
#include "app/cli/jobs.h"
#include "app/cli/pass_options.h"
#include "app/cli/picture_options.h"

#include <memory>

namespace fumage::cli {

namespace {

struct RenderArguments {
    PictureOptions picture;
    PassOptions passes;
    std::string jobs; ///< file of a list of them, in place of all of the above; empty: none
    bool asJson = false;
};

/// Adds --jobs, which says all that the other options say.
void addJobsTo(CLI::App& command, RenderArguments& arguments)
{
    const std::vector<CLI::Option*> others = command.get_options([&](const CLI::Option* option) { return option != command.get_help_ptr(); });
    CLI::Option* jobs = command.add_option("--jobs", arguments.jobs, "Do a list of exports, such as the editor's queue saves: one after the other, also after one that fails; - is standard input")->type_name("FILE");
    for (CLI::Option* other : others) {
        jobs->excludes(other);
    }
    addJson(command, arguments.asJson);
    command.get_option("--json")->needs(jobs);
    command.get_option("preset")->required(false);
}

Status render(const RenderArguments& arguments)
{
    if (!arguments.jobs.empty()) {
        return doJobs(arguments.jobs, arguments.asJson);
    }
    return arguments.picture.effect.forEach(arguments.picture.output, [&](const NamedPreset& named) -> Status {
        Result<PictureJob> job = arguments.picture.jobFor(named);
        if (!job) {
            return job.error();
        }
        if (Status status = arguments.passes.applyTo(job.value().plan); !status) {
            return status;
        }
        const Result<std::optional<Flipbook>> done = writePictures(job.value());
        return done ? Status(Done{}) : done.error();
    });
}

} // namespace

void addRender(CLI::App& program, Action& action)
{
    auto arguments = std::make_shared<RenderArguments>();
    CLI::App* command = program.add_subcommand("render", "Render frames of a preset to numbered pictures");
    arguments->picture.addTo(*command, "File to write; #### stands for the frame number, - is standard output (one frame). In a folder, and by default, the preset's name", "Picture size: 512 or 640x360. Default: the preset's");
    arguments->picture.addFormat(*command);
    arguments->picture.manifest.addTo(*command);
    arguments->picture.addSkipping(*command);
    arguments->passes.addLayersTo(*command);
    addJobsTo(*command, *arguments);
    command->footer("PNG is sRGB with straight alpha, after exposure and view transform; EXR is linear with premultiplied alpha, before them: a filmic look is in the PNG only.\n"
                    "--passes makes layers of one EXR: sixway_a.R, motion.X (pixels from one picture to the next, right; Y up), depth.Z (m), normal.X and so on.\n"
                    "Examples:\n"
                    "  fumage-cli render chimney --frames 40 --output chimney.png\n"
                    "  fumage-cli render my.json --frames 0-63 --size 1024 --set look.opacity=8 --output out/smoke_####.exr\n"
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
