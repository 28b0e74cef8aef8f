#include "app/cli/command.h"

#include "core/export/plan.h"
#include "core/noise/texture.h"

#include <memory>

namespace fumage::cli {

namespace {

struct BakeOptions {
    EffectOptions effect;
    std::string output;
    int size = 512;
    float depth = 0.0F;
    bool wide = false;
};

Status bake(const BakeOptions& options)
{
    const Result<Effect> effect = options.effect.load();
    if (!effect) {
        return effect.error();
    }
    ExportPlan plan;
    plan.kind = ExportKind::NoiseTexture;
    plan.output = options.output;
    plan.format = formatOf(plan.output, options.wide);
    plan.noiseSize = options.size;
    plan.noiseDepth = options.depth;
    const auto done = runExport(effect.value(), plan, {}, interruption());
    return done ? Status(Done{}) : done.error();
}

} // namespace

void addBakeNoise(CLI::App& program, Action& action)
{
    auto options = std::make_shared<BakeOptions>();
    CLI::App* command = program.add_subcommand("bake-noise", "Bake the noise texture of a preset to a seamless grey picture");
    options->effect.addTo(*command);
    command->add_option("-o,--output", options->output, "File to write, .png or .exr")->required()->type_name("FILE");
    command->add_option("--size", options->size, "Edge in pixels, any from 1 to 4096")->check(CLI::Range(1, kMaxTextureSize))->capture_default_str();
    command->add_option("--depth", options->depth, "Where to cut the third axis, 0 to 1")->check(CLI::Range(0.0, 1.0))->capture_default_str();
    command->add_flag("--wide", options->wide, "16-bit PNG or 32-bit EXR");
    command->callback([options, &action] { action = [options] { return bake(*options); }; });
}

} // namespace fumage::cli
