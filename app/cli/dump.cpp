#include "app/cli/command.h"
#include "app/cli/export_arguments.h"
#include "app/cli/file_choice.h"
#include "app/cli/kept_apart.h"
#include "app/cli/manifest_option.h"
#include "app/cli/progress.h"

#include "core/base/memory.h"
#include "core/export/manifest/recorded.h"
#include "core/export/data/particle_dump.h"
#include "core/export/jobs/jobs.h"
#include "core/export/plan.h"

#include <memory>

namespace fumage::cli {

namespace {

struct DumpOptions {
    EffectOptions effect;
    std::string output{kStandardStream};
    std::string frames;
    std::string format;
    ExportArguments options;
    ManifestOption manifest;
};

Status dumpToStandardOutput(
    const DumpOptions& options, const NamedPreset& named, const ParticleSequenceOptions& sequence)
{
    if (sequence.frames.count() > 1) {
        return Error{ErrorCode::OutOfRange, makeMessage("several frames are several files"),
            "--frames " + options.frames, makeMessage("Name a file for them, as in --output smoke_####.csv")};
    }
    const Result<std::string> text = dumpParticles(named.preset.scene, sequence.frames.first,
        formatNamed(kAllParticleFormats, options.format), sequence.up, ProgressBar("Writing").task());
    return text ? print(text.value()) : Status(text.error());
}

Status dumpToFiles(
    const DumpOptions& options, const NamedPreset& named, ParticleSequenceOptions sequence, JobFiles& writtenBefore)
{
    const std::string_view ending = fileEnding(sequence.format);
    const NumberedFiles files{sequence.output, sequence.frames, ending, {}};
    const std::filesystem::path manifest = options.manifest.fileFor(sequence.output);
    if (Status status = keepApart(named.name, files, manifest, writtenBefore); !status) {
        return status;
    }
    const ManifestJob job{"particles",
        {{"format", std::string(ending.substr(1))}, {"up", std::string(options.options.textOf("up"))}},
        named.preset.scene};
    const auto write = [&](const FrameSink& written) {
        sequence.written = written;
        ProgressBar bar("Writing");
        return dumpSequence(named.preset.scene, sequence, bar.task());
    };
    if (Status status = recordNumbered(job, manifest, files, write); !status) {
        return status;
    }
    tellWritten(sequence.output, sequence.frames, ending);
    return Done{};
}

Status dumpOne(const DumpOptions& options, const NamedPreset& named, JobFiles& writtenBefore)
{
    ParticleSequenceOptions sequence;
    const Result<FrameRange> frames = oneFrameFor(options.frames, named);
    if (!frames) {
        return frames.error();
    }
    sequence.frames = frames.value();
    sequence.up = options.options.textOf("up") == nameOf(UpAxis::Z) ? UpAxis::Z : UpAxis::Y;
    if (options.output == kStandardStream) {
        return withinMemory([&] { return dumpToStandardOutput(options, named, sequence); });
    }
    const Result<FileChoice<ParticleFormat>> choice =
        chooseFile(options.output, options.format, named.name, kAllParticleFormats);
    if (!choice) {
        return choice.error();
    }
    sequence.output = choice.value().file;
    sequence.format = choice.value().format;
    sequence.source = named.file;
    return withinMemory([&] { return dumpToFiles(options, named, sequence, writtenBefore); });
}

Status dump(const DumpOptions& options)
{
    JobFiles written;
    return options.effect.forEach(
        options.output, [&](const NamedPreset& named) { return dumpOne(options, named, written); });
}

} // namespace

void addDump(CLI::App& program, Action& action)
{
    auto options = std::make_shared<DumpOptions>();
    CLI::App* command = program.add_subcommand("dump", "Write the particles of frames as CSV, PLY or a point cache");
    options->effect.addTo(*command);
    command->add_option("-f,--frame,--frames", options->frames, kOneFrameHelp)->type_name("RANGE");
    command
        ->add_option("--format", options->format,
            "csv, ply (binary), or pcache (Unity's point cache, in Unity's axes). Default: by the ending of the file")
        ->check(CLI::IsMember({"csv", "ply", "pcache"}));
    options->options.addTo(*command, "up", "Axis that points up: y, or z as in Blender, 3ds Max and Unreal", "y");
    command
        ->add_option(
            "-o,--output", options->output, "File to write; #### stands for the frame number, - is standard output")
        ->type_name("FILE")
        ->capture_default_str();
    options->manifest.addTo(*command);
    command->callback([options, &action] { action = [options] { return dump(*options); }; });
}

} // namespace fumage::cli
