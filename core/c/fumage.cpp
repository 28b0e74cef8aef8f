#include "core/fumage.h"

#include "core/base/parallel.h"
#include "core/effect/assignment.h"
#include "core/effect/value.h"
#include "core/live/live_simulation.h"
#include "core/preset/library.h"

#include "core/version.h"
#include "core/preset/preset_file.h"

#include <exception>
#include <memory>
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

/// The same for a call that could fail, of a smoke that has started; NULL, and one that has not, fail and keep their
/// error.
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

/// Sets what is to be set before the smoke starts.
/// @param settings "key=value", the last followed by nullptr
Status applySettings(Effect& effect, const char* const* settings)
{
    for (; settings != nullptr && *settings != nullptr; ++settings) {
        if (const Result<bool> clamped = applyAssignment(effect, *settings); !clamped) {
            return clamped.error();
        }
    }
    return Done{};
}

Result<LiveSimulation> started(
    Result<PresetReading> reading, const char* const* settings, const fumage_options* options)
{
    if (!reading) {
        return reading.error();
    }
    Effect effect = std::move(reading).value().preset.scene.effect();
    if (Status status = applySettings(effect, settings); !status) {
        return status.error();
    }
    LiveOptions live;
    if (options != nullptr) {
        live.stepsPerSecond = options->steps_per_second;
        live.mostParticles = options->most_particles;
        live.mostStepsAtOnce = options->most_steps_at_once == 0 ? live.mostStepsAtOnce : options->most_steps_at_once;
        live.budgetMs = options->budget_ms;
    }
    return LiveSimulation::start(effect, live);
}

/// @param read gives the preset
template <class Read>
fumage_smoke* create(
    const char* text, const char* const* settings, const fumage_options* options, const Read& read) noexcept
{
    auto* const smoke = new (std::nothrow) fumage_smoke; // fumage_destroy() deletes it: C owns no unique_ptr
    if (smoke == nullptr) {
        return nullptr;
    }
    guarded(*smoke, 0, [&] {
        Result<LiveSimulation> made = started(read(std::string(text == nullptr ? "" : text)), settings, options);
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

int moveEmitter(
    fumage_smoke* smoke, Move move, const float* position, const float* normal, const float* velocity) noexcept
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
template <class Number = float, class Column>
const Number* numbers(fumage_smoke* smoke, const Column& column) noexcept
{
    if (smoke == nullptr || !smoke->simulation) {
        return nullptr;
    }
    return guarded<const Number*>(*smoke, nullptr, [&] { return column(*smoke->simulation); });
}

/// A column that is found when it is asked for, which may fail, or NULL.
/// @param find gives Result<std::span<...>>
template <class Find>
const float* found(fumage_smoke* smoke, const Find& find) noexcept
{
    const float* first = nullptr;
    (void)running(smoke, [&](LiveSimulation& simulation) {
        const auto column = find(simulation);
        if (!column) {
            keep(*smoke, column.error());
            return -1;
        }
        first = &column.value().front().x;
        return 0;
    });
    return first;
}

/// How many threads the process may use; nothing: all there are.
std::unique_ptr<ThreadLimit>& threadLimit()
{
    static std::unique_ptr<ThreadLimit> limit;
    return limit;
}

} // namespace

const char* fumage_version(void)
{
    return FUMAGE_VERSION;
}

fumage_smoke* fumage_create_from_json(const char* json, const fumage_options* options)
{
    return fumage_create_from_json_with(json, nullptr, options);
}

fumage_smoke* fumage_create_from_name(const char* name, const fumage_options* options)
{
    return fumage_create_from_name_with(name, nullptr, options);
}

fumage_smoke* fumage_create_from_json_with(const char* json, const char* const* settings, const fumage_options* options)
{
    return create(json, settings, options, [](const std::string& text) { return parsePreset(text); });
}

fumage_smoke* fumage_create_from_name_with(const char* name, const char* const* settings, const fumage_options* options)
{
    return create(name, settings, options, [](const std::string& text) { return loadPreset(text); });
}

int fumage_limit_threads(int threads)
{
    if (threads < 0) {
        return -1;
    }
    try {
        threadLimit().reset(); // of two the smaller holds
        threadLimit() = threads == 0 ? nullptr : std::make_unique<ThreadLimit>(threads);
        return 0;
    } catch (...) {
        return -1;
    }
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

float fumage_share(const fumage_smoke* smoke)
{
    return smoke == nullptr || !smoke->simulation ? 0.0F : smoke->simulation->share();
}

int fumage_is_over_budget(const fumage_smoke* smoke)
{
    return smoke != nullptr && smoke->simulation && smoke->simulation->isOverBudget() ? 1 : 0;
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

const float* fumage_lit_colour(fumage_smoke* smoke, const float* eye)
{
    const std::optional<glm::vec3> place = eye == nullptr ? std::nullopt : std::optional(vectorOf(eye));
    return found(smoke, [&](LiveSimulation& simulation) { return simulation.litColours(place); });
}

const float* fumage_normal(fumage_smoke* smoke)
{
    return found(smoke, [](LiveSimulation& simulation) { return simulation.normals(); });
}

const float* fumage_age(fumage_smoke* smoke)
{
    return numbers(smoke, [](LiveSimulation& simulation) { return simulation.ages().data(); });
}

const float* fumage_life(fumage_smoke* smoke)
{
    return numbers(smoke, [](LiveSimulation& simulation) { return simulation.appearance().life.data(); });
}

const float* fumage_velocity_x(fumage_smoke* smoke)
{
    return numbers(smoke, [](LiveSimulation& simulation) { return simulation.particles().vx.data(); });
}

const float* fumage_velocity_y(fumage_smoke* smoke)
{
    return numbers(smoke, [](LiveSimulation& simulation) { return simulation.particles().vy.data(); });
}

const float* fumage_velocity_z(fumage_smoke* smoke)
{
    return numbers(smoke, [](LiveSimulation& simulation) { return simulation.particles().vz.data(); });
}

const uint64_t* fumage_id(fumage_smoke* smoke)
{
    return numbers<uint64_t>(smoke, [](LiveSimulation& simulation) { return simulation.ids().data(); });
}
