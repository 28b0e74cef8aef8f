#include "app/cli/command.h"
#include "app/cli/picture_options.h"

#include <memory>

namespace fumage::cli {

namespace {

Status render(const PictureOptions& options)
{
    return options.effect.forEach(options.output, [&](const NamedEffect& named) -> Status {
        const Result<PictureJob> job = options.jobFor(named);
        if (!job) {
            return job.error();
        }
        const Result<std::optional<Flipbook>> done = writePictures(job.value());
        return done ? Status(Done{}) : done.error();
    });
}

} // namespace

void addRender(CLI::App& program, Action& action)
{
    auto options = std::make_shared<PictureOptions>();
    CLI::App* command = program.add_subcommand("render", "Render frames of a preset to numbered pictures");
    options->addTo(*command, "File to write; #### stands for the frame number, - is standard output (one frame). In a folder, and by default, the preset's name", "Picture size: 512 or 640x360. Default: the preset's");
    command->footer("PNG is sRGB with straight alpha, after exposure and view transform; EXR is linear with premultiplied alpha, before them: a filmic look is in the PNG only.\n"
                    "Examples:\n"
                    "  fumage-cli render chimney --frames 40 --output chimney.png\n"
                    "  fumage-cli render my.json --frames 0-63 --size 1024 --set look.opacity=8 --output out/smoke_####.exr");
    command->callback([options, &action] { action = [options] { return render(*options); }; });
}

} // namespace fumage::cli
