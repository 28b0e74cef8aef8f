#include "app/cli/command.h"
#include "app/cli/pass_options.h"
#include "app/cli/picture_options.h"

#include <memory>

namespace fumage::cli {

namespace {

struct RenderArguments {
    PictureOptions picture;
    PassOptions passes;
};

Status render(const RenderArguments& arguments)
{
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
    command->footer("PNG is sRGB with straight alpha, after exposure and view transform; EXR is linear with premultiplied alpha, before them: a filmic look is in the PNG only.\n"
                    "--passes makes layers of one EXR: sixway_a.R, motion.X (pixels from one picture to the next, right; Y up), depth.Z (m), normal.X and so on.\n"
                    "Examples:\n"
                    "  fumage-cli render chimney --frames 40 --output chimney.png\n"
                    "  fumage-cli render my.json --frames 0-63 --size 1024 --set look.opacity=8 --output out/smoke_####.exr\n"
                    "  fumage-cli render explosion --passes all --output out/boom_####.exr");
    command->callback([arguments, &action] { action = [arguments] { return render(*arguments); }; });
}

} // namespace fumage::cli
