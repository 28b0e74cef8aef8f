#include "app/cli/command.h"

#include "core/base/simd.h"
#include "core/base/text.h"
#include "core/effect/parameter_table.h"
#include "core/effect/sampling.h"
#include "core/effect/value.h"
#include "core/preset/library.h"
#include "core/simulation/schedule.h"
#include "core/version.h"

#include <memory>
#include <sstream>

namespace fumage::cli {

namespace {

Status info(const std::string& name)
{
    const Result<PresetReading> reading = readPreset(name);
    if (!reading) {
        return reading.error();
    }
    const Preset& preset = reading.value().preset;
    const Effect& effect = preset.effect;
    const Schedule schedule = makeSchedule(sampled(effect));
    std::ostringstream out;
    out << printable(preset.name) << "\n"
        << printable(preset.description) << "\n\n";
    out << "particles   " << schedule.capacity() << " at most, each living " << static_cast<float>(schedule.lifetimeSteps) * schedule.dt << " s\n";
    out << "timeline    " << effect.timeline.length << " frames at " << effect.timeline.frameRate << " frames/s" << (effect.timeline.loop ? ", looping" : "") << "\n";
    out << "picture     " << effect.output.width << " x " << effect.output.height << " pixels\n\n";
    out << "What differs from a new document:\n";
    for (const Parameter* parameter : differences(effect, Effect{})) {
        out << "  " << parameter->key << " = " << formatText(*parameter, parameter->get(effect), true) << "\n";
    }
    return print(out.str());
}

Status machine()
{
    std::ostringstream out;
    out << "fumage-cli " << FUMAGE_VERSION << "\ninstruction sets, best first:";
    for (const std::string& name : availableSimdTargets()) {
        out << ' ' << name;
    }
    out << "\nuser presets: " << userPresetFolder().string() << "\n";
    return print(out.str());
}

} // namespace

void addInfo(CLI::App& program, Action& action)
{
    auto preset = std::make_shared<std::string>();
    CLI::App* command = program.add_subcommand("info", "Show what a preset is, or without one what this machine has");
    command->add_option("preset", *preset, "Name or file")->type_name("PRESET");
    command->callback([preset, &action] { action = [preset] { return preset->empty() ? machine() : info(*preset); }; });
}

} // namespace fumage::cli
