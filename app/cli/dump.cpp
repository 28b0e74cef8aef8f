#include "app/cli/command.h"

#include "core/export/particle_dump.h"
#include "core/export/sequence.h"

#include <memory>

namespace fumage::cli {

namespace {

struct DumpOptions {
    EffectOptions effect;
    std::string output = "-";
    int frame = 0;
    std::string format = "csv";
};

Status dump(const DumpOptions& options)
{
    const Result<Effect> effect = options.effect.load();
    if (!effect) {
        return effect.error();
    }
    const ParticleFormat format = options.format == "ply" ? ParticleFormat::Ply : ParticleFormat::Csv;
    const Result<std::string> text = dumpParticles(effect.value(), options.frame, format, interruption());
    return text ? writeOutput(options.output, text.value()) : Status(text.error());
}

} // namespace

void addDump(CLI::App& program, Action& action)
{
    auto options = std::make_shared<DumpOptions>();
    CLI::App* command = program.add_subcommand("dump", "Write the particles of one frame as CSV or PLY");
    options->effect.addTo(*command);
    command->add_option("-f,--frame", options->frame, "Frame number")->check(CLI::Range(0, kMaxFrame))->capture_default_str();
    command->add_option("--format", options->format, "csv or ply (binary)")->check(CLI::IsMember({"csv", "ply"}))->capture_default_str();
    command->add_option("-o,--output", options->output, "File to write; - is standard output")->type_name("FILE")->capture_default_str();
    command->callback([options, &action] { action = [options] { return dump(*options); }; });
}

} // namespace fumage::cli
