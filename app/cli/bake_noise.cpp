#include "app/cli/number_options.h"
#include "app/cli/picture_options.h"

#include "core/noise/texture.h"

#include <memory>

namespace fumage::cli {

namespace {

struct BakeOptions {
    EffectOptions effect;
    std::string output;
    int size = 512;
    ExportArguments options;
    bool wide = false;
};

Status bakeOne(const BakeOptions& options, const NamedPreset& named)
{
    PictureJob job{named.preset.scene, {}};
    job.plan.kind = ExportKind::NoiseTexture;
    job.plan.source = named.file;
    job.plan.noise.size = options.size;
    if (Status status = options.options.applyTo(job.plan); !status) {
        return status;
    }
    if (Status status = chooseOutput(options.output, "", named.name + "_noise", job.plan); !status) {
        return status;
    }
    job.plan.format = formatOf(job.plan.output, options.wide);
    const Result<std::optional<Flipbook>> done = writePictures(job);
    return done ? Status(Done{}) : done.error();
}

Status bake(const BakeOptions& options)
{
    return options.effect.forEach(options.output, [&](const NamedPreset& named) { return bakeOne(options, named); });
}

} // namespace

void addBakeNoise(CLI::App& program, Action& action)
{
    auto options = std::make_shared<BakeOptions>();
    CLI::App* command =
        program.add_subcommand("bake-noise", "Bake the noise texture of a preset to a seamless grey picture");
    options->effect.addTo(*command);
    command
        ->add_option("-o,--output", options->output,
            "File to write, .png, .exr or .tga; - is standard output. In a folder, the preset's name and _noise")
        ->required()
        ->type_name("FILE");
    addWhole(*command, "--size", options->size, 1, kMaxTextureSize, "Edge in pixels, any from 1 to 4096");
    options->options.addTo(*command, "noise_depth");
    command->add_flag("--wide", options->wide, "16-bit PNG or 32-bit EXR");
    command->callback([options, &action] { action = [options] { return bake(*options); }; });
}

} // namespace fumage::cli
