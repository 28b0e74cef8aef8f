// The functions of fumage.h that are about one layer.
#include "core/c/columns.h"
#include "core/c/smoke.h"
#include "core/scene/layer_assignment.h"

using namespace fumage;
using namespace fumage::c;

namespace {

/// Runs what is about a layer; a number that no layer has fails.
template <class T, class Body>
T inLayer(fumage_smoke* smoke, int layer, T failed, const Body& body) noexcept
{
    return running(smoke, failed, [&](LiveScene& scene) {
        if (layer < 0 || static_cast<std::size_t>(layer) >= scene.layers()) {
            keep(*smoke,
                Error{ErrorCode::OutOfRange, makeMessage("there is no layer number %1", layer), {},
                    makeMessage("Give a number from 0 to %1", scene.layers() - 1)});
            return failed;
        }
        return body(scene, static_cast<std::size_t>(layer));
    });
}

/// A column of a layer, or NULL.
const float* numbers(fumage_smoke* smoke, int layer, Column column) noexcept
{
    return inLayer<const float*>(smoke, layer, nullptr,
        [&](LiveScene& scene, std::size_t of) { return slotsOf(scene, of) == 0 ? nullptr : column(scene, of); });
}

using Move = Status (LiveScene::*)(std::size_t, const EmitterPose&);

int moveEmitter(fumage_smoke* smoke, int layer, Move move, const float* position, const float* normal,
    const float* velocity) noexcept
{
    return inLayer(smoke, layer, -1, [&](LiveScene& scene, std::size_t of) {
        return resultOf(*smoke, (scene.*move)(of, poseFrom(scene.emitter(of), position, normal, velocity)));
    });
}

} // namespace

int fumage_layers(const fumage_smoke* smoke)
{
    return isRunning(smoke) ? static_cast<int>(smoke->scene->layers()) : 0;
}

const char* fumage_layer_name(fumage_smoke* smoke, int layer)
{
    return inLayer<const char*>(
        smoke, layer, nullptr, [&](LiveScene& scene, std::size_t of) { return scene.scene().layers[of].name.c_str(); });
}

int fumage_find_layer(fumage_smoke* smoke, const char* name)
{
    return running(smoke, -1, [&](LiveScene& scene) {
        const Result<std::size_t> layer = layerNamed(scene.scene(), name == nullptr ? "" : name);
        if (!layer) {
            keep(*smoke, layer.error());
            return -1;
        }
        return static_cast<int>(layer.value());
    });
}

int fumage_set_layer_emitter(
    fumage_smoke* smoke, int layer, const float* position, const float* normal, const float* velocity)
{
    return moveEmitter(smoke, layer, &LiveScene::setEmitter, position, normal, velocity);
}

int fumage_place_layer_emitter(
    fumage_smoke* smoke, int layer, const float* position, const float* normal, const float* velocity)
{
    return moveEmitter(smoke, layer, &LiveScene::placeEmitter, position, normal, velocity);
}

int fumage_set_layer_share(fumage_smoke* smoke, int layer, float share)
{
    return inLayer(smoke, layer, -1, [&](LiveScene& scene, std::size_t of) {
        scene.setShare(of, share);
        return 0;
    });
}

float fumage_layer_share(fumage_smoke* smoke, int layer)
{
    return inLayer(smoke, layer, 0.0F, [](LiveScene& scene, std::size_t of) { return scene.share(of); });
}

int fumage_burst_layer(fumage_smoke* smoke, int layer)
{
    return inLayer(smoke, layer, -1, [](LiveScene& scene, std::size_t of) {
        scene.burst(of);
        return 0;
    });
}

size_t fumage_layer_living(fumage_smoke* smoke, int layer)
{
    return inLayer(smoke, layer, size_t{0},
        [](LiveScene& scene, std::size_t of) { return scene.isVisible(of) ? scene.living(of) : 0; });
}

size_t fumage_layer_slots(fumage_smoke* smoke, int layer)
{
    return inLayer(smoke, layer, size_t{0}, [](LiveScene& scene, std::size_t of) { return slotsOf(scene, of); });
}

const float* fumage_layer_x(fumage_smoke* smoke, int layer)
{
    return numbers(smoke, layer, kX);
}

const float* fumage_layer_y(fumage_smoke* smoke, int layer)
{
    return numbers(smoke, layer, kY);
}

const float* fumage_layer_z(fumage_smoke* smoke, int layer)
{
    return numbers(smoke, layer, kZ);
}

const float* fumage_layer_radius(fumage_smoke* smoke, int layer)
{
    return numbers(smoke, layer, kRadius);
}

const float* fumage_layer_colour(fumage_smoke* smoke, int layer)
{
    return numbers(smoke, layer, kColour);
}

const float* fumage_layer_lit_colour(fumage_smoke* smoke, int layer, const float* eye)
{
    return inLayer<const float*>(smoke, layer, nullptr,
        [&](LiveScene& scene, std::size_t of) { return firstOf(*smoke, scene.litColours(of, eyeOf(eye))); });
}

const float* fumage_layer_normal(fumage_smoke* smoke, int layer)
{
    return inLayer<const float*>(
        smoke, layer, nullptr, [&](LiveScene& scene, std::size_t of) { return firstOf(*smoke, scene.normals(of)); });
}

const float* fumage_layer_age(fumage_smoke* smoke, int layer)
{
    return numbers(smoke, layer, kAge);
}

const float* fumage_layer_life(fumage_smoke* smoke, int layer)
{
    return numbers(smoke, layer, kLife);
}

const float* fumage_layer_velocity_x(fumage_smoke* smoke, int layer)
{
    return numbers(smoke, layer, kVelocityX);
}

const float* fumage_layer_velocity_y(fumage_smoke* smoke, int layer)
{
    return numbers(smoke, layer, kVelocityY);
}

const float* fumage_layer_velocity_z(fumage_smoke* smoke, int layer)
{
    return numbers(smoke, layer, kVelocityZ);
}

const uint64_t* fumage_layer_id(fumage_smoke* smoke, int layer)
{
    return inLayer<const uint64_t*>(smoke, layer, nullptr,
        [](LiveScene& scene, std::size_t of) { return slotsOf(scene, of) == 0 ? nullptr : scene.ids(of).data(); });
}
