#include "core/fumage.h"

#include "core/effect/value.h"
#include "core/live/live_simulation.h"
#include "core/preset/library.h"

#include "core/version.h"

#include <exception>
#include <new>
#include <string>

using namespace fumage;

struct fumage_smoke {
    std::optional<LiveSimulation> simulation; ///< none: it did not start
    std::optional<std::string> error; ///< of the last call that could fail
    bool outOfMemory = false; ///< and no text could be kept
};

namespace {

constexpr const char* kOutOfMemory = "out of memory";

/// Keeps an error for fumage_error().
void keep(fumage_smoke& smoke, const Error& error)
{
    smoke.error = error.text();
}

/// Runs what may throw: nothing does on purpose, but memory may end.
/// @return what body returns, or failed
template <class T, class Body>
T guarded(fumage_smoke& smoke, T failed, const Body& body) noexcept
{
    try {
        return body();
    } catch (const std::exception& exception) {
        try {
            smoke.error = exception.what();
        } catch (...) {
            smoke.outOfMemory = true;
        }
    } catch (...) {
        smoke.outOfMemory = true;
    }
    return failed;
}

/// The same for a call that could fail, of a smoke that has started; NULL, and one that has not, fail and keep their error.
template <class Body>
int running(fumage_smoke* smoke, const Body& body) noexcept
{
    if (smoke == nullptr || !smoke->simulation) {
        return -1;
    }
    smoke->error.reset();
    smoke->outOfMemory = false;
    return guarded(*smoke, -1, [&] { return body(*smoke->simulation); });
}

int resultOf(fumage_smoke& smoke, const Status& status)
{
    if (status) {
        return 0;
    }
    keep(smoke, status.error());
    return -1;
}

Result<LiveSimulation> started(const Result<PresetReading>& reading, const fumage_options* options)
{
    if (!reading) {
        return reading.error();
    }
    LiveOptions live;
    if (options != nullptr) {
        live.stepsPerSecond = options->steps_per_second;
        live.mostParticles = options->most_particles;
        live.mostStepsAtOnce = options->most_steps_at_once == 0 ? live.mostStepsAtOnce : options->most_steps_at_once;
        live.budgetMs = options->budget_ms;
    }
    return LiveSimulation::start(reading.value().preset.effect, live);
}

/// @param read gives the preset
template <class Read>
fumage_smoke* create(const char* text, const fumage_options* options, const Read& read) noexcept
{
    auto* const smoke = new (std::nothrow) fumage_smoke; // fumage_destroy() deletes it: C owns no unique_ptr
    if (smoke == nullptr) {
        return nullptr;
    }
    guarded(*smoke, 0, [&] {
        Result<LiveSimulation> made = started(read(std::string(text == nullptr ? "" : text)), options);
        if (made) {
            smoke->simulation.emplace(std::move(made).value());
        } else {
            keep(*smoke, made.error());
        }
        return 0;
    });
    return smoke;
}

glm::vec3 vectorOf(const float* numbers)
{
    return numbers == nullptr ? glm::vec3(0.0F) : glm::vec3(numbers[0], numbers[1], numbers[2]);
}

using Move = Status (LiveSimulation::*)(const EmitterPose&);

int moveEmitter(fumage_smoke* smoke, Move move, const float* position, const float* normal, const float* velocity) noexcept
{
    return running(smoke, [&](LiveSimulation& simulation) {
        EmitterPose pose = simulation.emitter();
        pose.position = position == nullptr ? pose.position : vectorOf(position);
        pose.normal = normal == nullptr ? pose.normal : vectorOf(normal);
        pose.velocity = vectorOf(velocity);
        return resultOf(*smoke, (simulation.*move)(pose));
    });
}

/// A column of numbers, or NULL.
template <class Column>
const float* numbers(fumage_smoke* smoke, const Column& column) noexcept
{
    if (smoke == nullptr || !smoke->simulation) {
        return nullptr;
    }
    return guarded<const float*>(*smoke, nullptr, [&] { return column(*smoke->simulation); });
}

} // namespace

const char* fumage_version(void)
{
    return FUMAGE_VERSION;
}

fumage_smoke* fumage_create_from_json(const char* json, const fumage_options* options)
{
    return create(json, options, [](const std::string& text) { return parsePreset(text); });
}

fumage_smoke* fumage_create_from_name(const char* name, const fumage_options* options)
{
    return create(name, options, [](const std::string& text) { return loadPreset(text); });
}

void fumage_destroy(fumage_smoke* smoke)
{
    delete smoke;
}

const char* fumage_error(const fumage_smoke* smoke)
{
    if (smoke == nullptr || smoke->outOfMemory) {
        return kOutOfMemory;
    }
    return smoke->error ? smoke->error->c_str() : nullptr;
}

int fumage_step(fumage_smoke* smoke, double seconds)
{
    return running(smoke, [&](LiveSimulation& simulation) {
        const Result<int> steps = simulation.step(seconds);
        if (!steps) {
            keep(*smoke, steps.error());
            return -1;
        }
        return steps.value();
    });
}

int fumage_set(fumage_smoke* smoke, const char* key, const char* value)
{
    return running(smoke, [&](LiveSimulation& simulation) {
        Effect effect = simulation.effect();
        const std::string assignment = std::string(key == nullptr ? "" : key) + '=' + (value == nullptr ? "" : value);
        const Result<bool> clamped = applyAssignment(effect, assignment);
        if (!clamped) {
            keep(*smoke, clamped.error());
            return -1;
        }
        const int result = resultOf(*smoke, simulation.setEffect(effect));
        return result == 0 && clamped.value() ? 1 : result;
    });
}

int fumage_set_emitter(fumage_smoke* smoke, const float* position, const float* normal, const float* velocity)
{
    return moveEmitter(smoke, &LiveSimulation::setEmitter, position, normal, velocity);
}

int fumage_place_emitter(fumage_smoke* smoke, const float* position, const float* normal, const float* velocity)
{
    return moveEmitter(smoke, &LiveSimulation::placeEmitter, position, normal, velocity);
}

void fumage_set_share(fumage_smoke* smoke, float share)
{
    if (smoke != nullptr && smoke->simulation) {
        smoke->simulation->setShare(share);
    }
}

void fumage_burst(fumage_smoke* smoke)
{
    if (smoke != nullptr && smoke->simulation) {
        smoke->simulation->burst();
    }
}

size_t fumage_living(const fumage_smoke* smoke)
{
    return smoke == nullptr || !smoke->simulation ? 0 : smoke->simulation->living();
}

size_t fumage_slots(const fumage_smoke* smoke)
{
    return smoke == nullptr || !smoke->simulation ? 0 : smoke->simulation->particles().capacity;
}

const float* fumage_x(fumage_smoke* smoke)
{
    return numbers(smoke, [](LiveSimulation& simulation) { return simulation.particles().x.data(); });
}

const float* fumage_y(fumage_smoke* smoke)
{
    return numbers(smoke, [](LiveSimulation& simulation) { return simulation.particles().y.data(); });
}

const float* fumage_z(fumage_smoke* smoke)
{
    return numbers(smoke, [](LiveSimulation& simulation) { return simulation.particles().z.data(); });
}

const float* fumage_radius(fumage_smoke* smoke)
{
    return numbers(smoke, [](LiveSimulation& simulation) { return simulation.appearance().radius.data(); });
}

const float* fumage_colour(fumage_smoke* smoke)
{
    return numbers(smoke, [](LiveSimulation& simulation) { return &simulation.colours().front().x; });
}
