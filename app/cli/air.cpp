#include "app/cli/command.h"
#include "app/cli/file_choice.h"
#include "app/cli/kept_apart.h"
#include "app/cli/manifest_option.h"
#include "app/cli/progress.h"

#include "core/base/memory.h"
#include "core/export/data/air_file.h"
#include "core/export/jobs/jobs.h"
#include "core/export/manifest/recorded.h"

#include <memory>
#include <sstream>

namespace fumage::cli {

namespace {

struct AirOptions {
    EffectOptions effect;
    std::string output;
    std::string frames;
    std::string format;
    ManifestOption manifest;
};

Result<AirSequenceOptions> sequenceOf(const AirOptions& options, const NamedPreset& named)
{
    AirSequenceOptions sequence;
    const Result<FrameRange> frames = oneFrameFor(options.frames, named);
    if (!frames) {
        return frames.error();
    }
    sequence.frames = frames.value();
    sequence.source = named.file;
    const Result<FileChoice<AirFormat>> choice = chooseFile(options.output, options.format, named.name, kAllAirFormats);
    if (!choice) {
        return choice.error();
    }
    sequence.output = choice.value().file;
    sequence.format = choice.value().format;
    return sequence;
}

/// Where the box is, which a Volume File does not say.
std::string boxOf(const AirGrid& grid)
{
    const glm::vec3 middle = grid.corner + 0.5F * grid.size();
    std::ostringstream text;
    text << "The box: " << grid.cells.x << " x " << grid.cells.y << " x " << grid.cells.z << " cells of " << grid.cell
         << " m, its middle at " << middle.x << ", " << middle.y << ", " << middle.z << " m\n";
    return text.str();
}

Status writeOne(const AirOptions& options, const NamedPreset& named, JobFiles& writtenBefore)
{
    Result<AirSequenceOptions> sequence = sequenceOf(options, named);
    if (!sequence) {
        return sequence.error();
    }
    const std::string_view ending = fileEnding(sequence.value().format);
    const std::filesystem::path& output = sequence.value().output;
    const NumberedFiles files{output, sequence.value().frames, ending, {}};
    const std::filesystem::path manifest = options.manifest.fileFor(output);
    if (Status status = keepApart(named.name, files, manifest, writtenBefore); !status) {
        return status;
    }
    AirGrid grid;
    const auto write = [&](const FrameSink& written) -> Status {
        sequence.value().written = written;
        ProgressBar bar("Writing");
        const Result<AirGrid> box =
            withinMemory([&] { return writeAir(named.preset.scene, sequence.value(), bar.task()); });
        grid = box ? box.value() : grid;
        return box ? Status(Done{}) : box.error();
    };
    const ManifestJob job{"air", {{"format", std::string(ending.substr(1))}}, named.preset.scene};
    if (Status status = recordNumbered(job, manifest, files, write); !status) {
        return status;
    }
    tellWritten(output, sequence.value().frames, ending);
    return print(boxOf(grid));
}

} // namespace

void addAir(CLI::App& program, Action& action)
{
    auto options = std::make_shared<AirOptions>();
    CLI::App* command =
        program.add_subcommand("air", "Write the air that carries the smoke as vector fields for engines");
    options->effect.addTo(*command);
    command->add_option("-f,--frame,--frames", options->frames, kOneFrameHelp)->type_name("RANGE");
    command
        ->add_option("--format", options->format,
            "fga (Unreal) or vf (Unity's Volume File). Default: by the ending of the file, else fga")
        ->check(CLI::IsMember({"fga", "vf"}));
    command
        ->add_option("-o,--output", options->output,
            "File to write; #### stands for the frame number. In a folder, and by default, the preset's name")
        ->type_name("FILE");
    options->manifest.addTo(*command);
    command->footer("Velocities in the middle of the cells, in the engine's axes: Unreal's are (x, z, y) of ours in "
                    "cm, Unity's (x, y, -z) in m. Particles of the engine that are moved\n"
                    "by them go with the smoke.\n"
                    "Example:\n"
                    "  fumage-cli air mushroom-cloud --frames 60 --output mushroom.fga");
    command->callback([options, &action] {
        action = [options] {
            JobFiles written;
            return options->effect.forEach(
                options->output, [&](const NamedPreset& named) { return writeOne(*options, named, written); });
        };
    });
}

} // namespace fumage::cli
