#include "app/cli/command.h"
#include "app/cli/export_arguments.h"
#include "app/cli/kept_apart.h"
#include "app/cli/manifest_option.h"
#include "app/cli/progress.h"

#include "core/base/memory.h"
#include "core/base/text.h"
#include "core/export/jobs/jobs.h"
#include "core/export/manifest/recorded.h"
#include "core/export/output_name.h"
#include "core/export/data/vdb_file.h"

#include <array>
#include <memory>

namespace fumage::cli {

namespace {

struct VolumeArguments {
    EffectOptions effect;
    std::string output;
    std::string frames;
    ExportArguments options;
    ManifestOption manifest;
};

Status writeOne(const VolumeArguments& arguments, const NamedPreset& named, JobFiles& writtenBefore)
{
    static constexpr std::array kEndings{kVdbEnding};
    VolumeSequenceOptions options;
    const Result<FrameRange> frames = oneFrameFor(arguments.frames, named);
    if (!frames) {
        return frames.error();
    }
    const Result<std::filesystem::path> path = outputPath(arguments.output, {kEndings, named.name});
    if (!path) {
        return path.error();
    }
    options.output = withEnding(path.value(), kEndings.front());
    options.frames = frames.value();
    ExportPlan plan;
    plan.kind = ExportKind::Volumes;
    if (Status status = arguments.options.applyTo(plan); !status) {
        return status;
    }
    options.longest = plan.volume.cells;
    options.voxel = plan.volume.voxel;
    options.up = plan.up.value_or(options.up);
    options.density = plan.volume.density;
    options.source = named.file;
    const NumberedFiles files{options.output, options.frames, kEndings.front(), {}};
    const std::filesystem::path manifest = arguments.manifest.fileFor(options.output);
    if (Status status = keepApart(named.name, files, manifest, writtenBefore); !status) {
        return status;
    }
    float voxel = 0.0F;
    {
        ProgressBar bar("Writing");
        const std::string size = options.voxel ? formatFloat(*options.voxel) + " m" : std::to_string(options.longest);
        ManifestJob job{"volumes", {{options.voxel ? "voxel" : "cells", size}, {"up", std::string(nameOf(options.up))}},
            named.preset.scene};
        if (options.density != DensityGrids::Together) { // as manifests were before there was a choice
            job.settings["density"] = nameOf(options.density);
        }
        const auto write = [&](const FrameSink& written) -> Status {
            options.written = written;
            const Result<float> used =
                withinMemory([&] { return writeVolumes(named.preset.scene, options, bar.task()); });
            voxel = used ? used.value() : voxel;
            return used ? Status(Done{}) : Status(used.error());
        };
        if (Status status = recordNumbered(job, manifest, files, write); !status) {
            return status;
        }
    }
    tellWritten(options.output, options.frames, kEndings.front());
    report("voxels of " + formatFloat(voxel) + " m");
    return Done{};
}

} // namespace

void addVolume(CLI::App& program, Action& action)
{
    auto arguments = std::make_shared<VolumeArguments>();
    CLI::App* command = program.add_subcommand("volume", "Write the smoke of frames as OpenVDB volumes");
    arguments->effect.addTo(*command);
    command->add_option("-f,--frame,--frames", arguments->frames, kOneFrameHelp)->type_name("RANGE");
    arguments->options.addTo(*command, "up", "Axis that points up: z as in Blender, or y as in Houdini and Maya", "z");
    arguments->options.addAllTo(*command, ExportKind::Volumes);
    command->get_option("--voxel")->excludes(command->get_option("--cells"));
    command
        ->add_option("-o,--output", arguments->output,
            "File to write; #### stands for the frame number. In a folder, and by default, the preset's name")
        ->type_name("FILE");
    arguments->manifest.addTo(*command);
    command->footer("Grids, in half floats: density (extinction, 1/m, as pictures and shadows have it; with --density "
                    "layers one a layer), vel (m/s), for "
                    "smoke in air or with glow temperature (about 1 at the source), and\n"
                    "for what glows flames. All frames have the same grids and the same voxels, whichever of them are "
                    "written at once.\n"
                    "Example:\n"
                    "  fumage-cli volume mushroom-cloud --frames 0-119 --cells 128 --output vdb/mushroom_####.vdb");
    command->callback([arguments, &action] {
        action = [arguments] {
            JobFiles written;
            return arguments->effect.forEach(
                arguments->output, [&](const NamedPreset& named) { return writeOne(*arguments, named, written); });
        };
    });
}

} // namespace fumage::cli
