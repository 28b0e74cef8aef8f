#include "app/cli/command.h"
#include "app/cli/picture_options.h"
#include "app/cli/progress.h"

#include "core/effect/parameter_table.h"
#include "core/effect/value.h"
#include "core/export/fit_camera.h"

#include <memory>

namespace fumage::cli {

namespace {

/// What the camera of one effect has to become, as options of other commands.
Result<std::string> optionsFor(const Scene& scene, const ExportPlan& plan)
{
    Scene fitted = scene;
    {
        ProgressBar bar("Looking");
        const Result<Camera> camera = fitCamera(scene, plan.frames, plan.outlierPercent, bar.task());
        if (!camera) {
            return camera.error();
        }
        fitted.camera = camera.value();
    }
    std::string text;
    const Effect found = fitted.effect();
    for (const Parameter* parameter : differences(found, scene.effect())) {
        if (isVisible(*parameter, found)) {
            std::string value = formatText(*parameter, parameter->get(found));
            std::erase_if(value,
                [](char letter) { return letter == ' ' || letter == '[' || letter == ']'; }); // one word for a shell
            text += (text.empty() ? "--set " : " --set ") + std::string(parameter->key) + "=" + value;
        }
    }
    return text + "\n";
}

Status fit(const PictureOptions& options)
{
    return options.effect.forEach([&](const NamedPreset& named) -> Status {
        // all frames, also of a preset that one picture carries
        Result<PictureJob> job = options.jobWithoutOutput(named, ExportKind::Video);
        if (!job) {
            return job.error();
        }
        if (Status status = options.options.applyTo(job.value().plan); !status) {
            return status;
        }
        const Result<std::string> text = optionsFor(job.value().scene, job.value().plan);
        return text ? print(text.value()) : Status(text.error());
    });
}

} // namespace

void addFit(CLI::App& program, Action& action)
{
    auto options = std::make_shared<PictureOptions>();
    CLI::App* command = program.add_subcommand(
        "fit", "Find where the camera sees all smoke, and print it as options of other commands");
    options->effect.addTo(*command);
    command->add_option("-f,--frame,--frames", options->frames, kFramesHelp)->type_name("RANGE");
    command
        ->add_option(
            "--size", options->size, "Picture size, of which the shape matters: 512 or 640x360. Default: the preset's")
        ->type_name("SIZE");
    options->options.addTo(*command, "ignore_outliers",
        "Percent of the smoke that may be outside, 0 to 5, for larger frames: stray sparks and puffs; what is left "
        "out is cut off at the border");
    command->footer("The camera looks the way it does; it moves until no border of any frame has smoke on it, and the "
                    "smoke fills the picture. render and flipbook do the\n"
                    "same with --fit, for the frames that they are asked for: one fit beforehand gives all parts of an "
                    "animation the same camera.\n"
                    "With --ignore-outliers the smoke fills the picture but for that share of it which needs the most "
                    "room.\n"
                    "Examples:\n"
                    "  fumage-cli fit forge-sparks --ignore-outliers 1\n"
                    "  fumage-cli render chimney --output out/chimney_####.exr $(fumage-cli fit chimney)");
    command->callback([options, &action] { action = [options] { return fit(*options); }; });
}

} // namespace fumage::cli
