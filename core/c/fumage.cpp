#include "core/fumage.h"

#include "core/base/parallel.h"
#include "core/c/columns.h"
#include "core/c/smoke.h"
#include "core/preset/library.h"
#include "core/preset/preset_file.h"
#include "core/scene/layer_assignment.h"
#include "core/version.h"

#include <memory>
#include <new>

using namespace fumage;
using namespace fumage::c;

namespace {

constexpr const char* kOutOfMemory = "out of memory";

/// Sets what is to be set before the smoke starts.
/// @param settings "key=value" or "layer/key=value", the last followed by nullptr
Status applySettings(Scene& scene, const char* const* settings)
{
    for (; settings != nullptr && *settings != nullptr; ++settings) {
        if (const Result<bool> clamped = applyToScene(scene, *settings); !clamped) {
            return clamped.error();
        }
    }
    return Done{};
}

Result<LiveScene> started(Result<PresetReading> reading, const char* const* settings, const fumage_options* options)
{
    if (!reading) {
        return reading.error();
    }
    Scene scene = std::move(reading).value().preset.scene;
    if (Status status = applySettings(scene, settings); !status) {
        return status.error();
    }
    LiveOptions live;
    if (options != nullptr) {
        live.stepsPerSecond = options->steps_per_second;
        live.mostParticles = options->most_particles;
        live.mostStepsAtOnce = options->most_steps_at_once == 0 ? live.mostStepsAtOnce : options->most_steps_at_once;
        live.budgetMs = options->budget_ms;
    }
    return LiveScene::start(scene, live);
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
        Result<LiveScene> made = started(read(std::string(text == nullptr ? "" : text)), settings, options);
        if (made) {
            smoke->scene.emplace(std::move(made).value());
        } else {
            keep(*smoke, made.error());
        }
        return 0;
    });
    return smoke;
}

using Move = Status (LiveScene::*)(const EmitterPose&);

int moveEmitters(
    fumage_smoke* smoke, Move move, const float* position, const float* normal, const float* velocity) noexcept
{
    return running(smoke, -1, [&](LiveScene& scene) {
        return resultOf(*smoke, (scene.*move)(poseFrom(scene.emitter(0), position, normal, velocity)));
    });
}

/// A column of the first layer, or NULL.
const float* numbers(fumage_smoke* smoke, Column column) noexcept
{
    if (!isRunning(smoke) || slotsOf(*smoke->scene, 0) == 0) {
        return nullptr;
    }
    return guarded<const float*>(*smoke, nullptr, [&] { return column(*smoke->scene, 0); });
}

/// Runs what is about a marker; a number that no marker has fails.
template <class T, class Body>
T ofMarker(fumage_smoke* smoke, int number, T failed, const Body& body) noexcept
{
    return running(smoke, failed, [&](const LiveScene& scene) {
        const std::vector<Marker>& markers = scene.scene().markers;
        if (number < 0 || static_cast<std::size_t>(number) >= markers.size()) {
            keep(*smoke, Error{ErrorCode::OutOfRange, makeMessage("there is no marker number %1", number), {}, {}});
            return failed;
        }
        return body(markers[static_cast<std::size_t>(number)]);
    });
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
    return running(smoke, -1, [&](LiveScene& scene) {
        const Result<int> steps = scene.step(seconds);
        if (!steps) {
            keep(*smoke, steps.error());
            return -1;
        }
        return steps.value();
    });
}

int fumage_set(fumage_smoke* smoke, const char* key, const char* value)
{
    return running(smoke, -1, [&](LiveScene& now) {
        Scene scene = now.scene();
        const std::string assignment = std::string(key == nullptr ? "" : key) + '=' + (value == nullptr ? "" : value);
        const Result<bool> clamped = applyToScene(scene, assignment);
        if (!clamped) {
            keep(*smoke, clamped.error());
            return -1;
        }
        const int result = resultOf(*smoke, now.setScene(scene));
        return result == 0 && clamped.value() ? 1 : result;
    });
}

int fumage_set_emitter(fumage_smoke* smoke, const float* position, const float* normal, const float* velocity)
{
    return moveEmitters(smoke, &LiveScene::setEmitters, position, normal, velocity);
}

int fumage_place_emitter(fumage_smoke* smoke, const float* position, const float* normal, const float* velocity)
{
    return moveEmitters(smoke, &LiveScene::placeEmitters, position, normal, velocity);
}

void fumage_set_share(fumage_smoke* smoke, float share)
{
    if (isRunning(smoke)) {
        smoke->scene->setShare(share);
    }
}

float fumage_share(const fumage_smoke* smoke)
{
    return isRunning(smoke) ? smoke->scene->share(0) : 0.0F;
}

int fumage_is_over_budget(const fumage_smoke* smoke)
{
    return isRunning(smoke) && smoke->scene->isOverBudget() ? 1 : 0;
}

void fumage_burst(fumage_smoke* smoke)
{
    if (isRunning(smoke)) {
        smoke->scene->burst();
    }
}

size_t fumage_living(const fumage_smoke* smoke)
{
    return isRunning(smoke) && smoke->scene->isVisible(0) ? smoke->scene->living(0) : 0;
}

size_t fumage_slots(const fumage_smoke* smoke)
{
    return isRunning(smoke) ? slotsOf(*smoke->scene, 0) : 0;
}

const float* fumage_x(fumage_smoke* smoke)
{
    return numbers(smoke, kX);
}

const float* fumage_y(fumage_smoke* smoke)
{
    return numbers(smoke, kY);
}

const float* fumage_z(fumage_smoke* smoke)
{
    return numbers(smoke, kZ);
}

const float* fumage_radius(fumage_smoke* smoke)
{
    return numbers(smoke, kRadius);
}

const float* fumage_colour(fumage_smoke* smoke)
{
    return numbers(smoke, kColour);
}

const float* fumage_lit_colour(fumage_smoke* smoke, const float* eye)
{
    return running<const float*>(
        smoke, nullptr, [&](LiveScene& scene) { return firstOf(*smoke, scene.litColours(0, eyeOf(eye))); });
}

const float* fumage_normal(fumage_smoke* smoke)
{
    return running<const float*>(smoke, nullptr, [&](LiveScene& scene) { return firstOf(*smoke, scene.normals(0)); });
}

const float* fumage_age(fumage_smoke* smoke)
{
    return numbers(smoke, kAge);
}

const float* fumage_life(fumage_smoke* smoke)
{
    return numbers(smoke, kLife);
}

const float* fumage_velocity_x(fumage_smoke* smoke)
{
    return numbers(smoke, kVelocityX);
}

const float* fumage_velocity_y(fumage_smoke* smoke)
{
    return numbers(smoke, kVelocityY);
}

const float* fumage_velocity_z(fumage_smoke* smoke)
{
    return numbers(smoke, kVelocityZ);
}

const uint64_t* fumage_id(fumage_smoke* smoke)
{
    if (!isRunning(smoke) || slotsOf(*smoke->scene, 0) == 0) {
        return nullptr;
    }
    return guarded<const uint64_t*>(*smoke, nullptr, [&] { return smoke->scene->ids(0).data(); });
}

int fumage_markers(const fumage_smoke* smoke)
{
    return isRunning(smoke) ? static_cast<int>(smoke->scene->scene().markers.size()) : 0;
}

const char* fumage_marker_name(fumage_smoke* smoke, int marker)
{
    return ofMarker<const char*>(smoke, marker, nullptr, [](const Marker& each) { return each.name.c_str(); });
}

double fumage_marker_seconds(fumage_smoke* smoke, int marker)
{
    return ofMarker(smoke, marker, -1.0, [](const Marker& each) { return each.seconds; });
}
