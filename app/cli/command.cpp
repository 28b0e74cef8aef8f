#include "app/cli/command.h"

#include "core/base/file.h"
#include "core/effect/value.h"
#include "core/preset/library.h"

#include <csignal>
#include <iostream>

#include <pthread.h>

namespace fumage::cli {

void EffectOptions::addTo(CLI::App& command)
{
    command.add_option("preset", preset, "Name of a preset (see 'fumage-cli presets') or path of a JSON file")->required()->type_name("PRESET");
    command.add_option("-s,--set", assignments, "Change a parameter, for example --set motion.wind=1.5; may be repeated")->type_name("KEY=VALUE")->take_all()->allow_extra_args(false);
}

Result<Effect> EffectOptions::load() const
{
    const Result<PresetReading> reading = loadPreset(preset);
    if (!reading) {
        return reading.error();
    }
    for (const std::string& warning : reading.value().warnings) {
        warn(warning);
    }
    Effect effect = reading.value().preset.effect;
    for (const std::string& assignment : assignments) {
        const Result<bool> clamped = applyAssignment(effect, assignment);
        if (!clamped) {
            Error error = clamped.error();
            error.place = "--set " + assignment;
            return error;
        }
        if (clamped.value()) {
            warn("--set " + assignment + ": out of range, the nearest allowed value is used");
        }
    }
    return effect;
}

std::stop_token interruption()
{
    // The signals are blocked everywhere and taken by one thread, which may do what a signal handler must not.
    static const std::stop_source source = [] {
        std::stop_source stop;
        sigset_t signals;
        sigemptyset(&signals);
        sigaddset(&signals, SIGINT);
        sigaddset(&signals, SIGTERM);
        pthread_sigmask(SIG_BLOCK, &signals, nullptr);
        std::thread([stop, signals]() mutable {
            int number = 0;
            sigwait(&signals, &number);
            stop.request_stop();
        }).detach();
        return stop;
    }();
    return source.get_token();
}

void warn(const std::string& text)
{
    std::cerr << "fumage-cli: warning: " << text << '\n';
}

Status writeOutput(const std::string& path, const std::string& text)
{
    if (path != "-") {
        return writeFileAtomically(path, text);
    }
    std::cout << text << std::flush;
    if (!std::cout) {
        return Error{ErrorCode::WriteFailed, "standard output cannot be written", "", ""};
    }
    return Done{};
}

} // namespace fumage::cli
