#pragma once

#include "core/effect/parameters/row.h"

namespace fumage {

inline constexpr std::array<std::string_view, 2> kCameraModes{"orbit", "fixed"};

template <>
inline constexpr Group<Camera> kGroup<Camera>{&Effect::camera, "camera", "Camera"};

template <>
inline constexpr std::array kRows<Camera>{
    row<&Camera::mode>({
        .key = "camera.mode",
        .label = "Mode",
        .synonyms = "orbit fixed free",
        .tip = "Around a target, or at a fixed place.",
        .choices = kCameraModes,
        .stage = Stage::Shade,
    }),
    row<&Camera::yaw>({
        .key = "camera.yaw",
        .label = "Yaw",
        .synonyms = "turn orbit rotate angle azimuth heading",
        .hard = {-360, 360},
        .soft = {-180, 180},
        .step = 1,
        .unit = Unit::Degrees,
        .tip = "Angle around the target, seen from above; 0 looks along -Z.",
        .visible = when("camera.mode", CameraMode::Orbit),
        .stage = Stage::Shade,
    }),
    row<&Camera::pitch>({
        .key = "camera.pitch",
        .label = "Pitch",
        .synonyms = "tilt elevation angle above below",
        .hard = {-89, 89},
        .step = 1,
        .unit = Unit::Degrees,
        .tip = "Angle above the horizon from which the target is seen.",
        .visible = when("camera.mode", CameraMode::Orbit),
        .stage = Stage::Shade,
    }),
    row<&Camera::distance>({
        .key = "camera.distance",
        .label = "Distance",
        .synonyms = "zoom near far close dolly range",
        .hard = {0.01, 10000},
        .soft = {0.5, 50},
        .step = 0.05,
        .unit = Unit::Metres,
        .scale = Scale::Log,
        .tip = "Distance from the target.",
        .visible = when("camera.mode", CameraMode::Orbit),
        .stage = Stage::Shade,
    }),
    row<&Camera::target>({
        .key = "camera.target",
        .label = "Target",
        .synonyms = "look at pivot focus center",
        .kind = Kind::Vector,
        .hard = kFarAway,
        .soft = {-10, 10},
        .step = 0.05,
        .unit = Unit::Metres,
        .tip = "The point that the camera looks at.",
        .visible = when("camera.mode", CameraMode::Orbit),
        .stage = Stage::Shade,
    }),
    row<&Camera::turntable>({
        .key = "camera.turntable",
        .label = "Turntable",
        .synonyms = "turn spin rotate orbit",
        .hard = {-3600, 3600},
        .soft = {-90, 90},
        .step = 1,
        .unit = Unit::DegreesPerSecond,
        .tip = "Rate at which the camera goes around the target.",
        .visible = when("camera.mode", CameraMode::Orbit),
        .stage = Stage::Shade,
    }),
    row<&Camera::position>({
        .key = "camera.position",
        .label = "Position",
        .synonyms = "place location move eye",
        .kind = Kind::Vector,
        .hard = kFarAway,
        .soft = {-20, 20},
        .step = 0.05,
        .unit = Unit::Metres,
        .tip = "Where the fixed camera stands.",
        .visible = when("camera.mode", CameraMode::Fixed),
        .stage = Stage::Shade,
    }),
    row<&Camera::view>({
        .key = "camera.view",
        .label = "View direction",
        .synonyms = "look direction aim",
        .kind = Kind::Direction,
        .hard = kComponents,
        .step = 0.01,
        .tip = "Where the fixed camera looks.",
        .visible = when("camera.mode", CameraMode::Fixed),
        .stage = Stage::Shade,
    }),
    row<&Camera::focalLength>({
        .key = "camera.focal_length",
        .label = "Focal length",
        .synonyms = "zoom lens wide field of view fov",
        .hard = {5, 1000},
        .soft = {15, 200},
        .step = 1,
        .unit = Unit::Millimetres,
        .scale = Scale::Log,
        .tip = "Of a lens on a sensor of 36 mm across the shorter side; longer brings the smoke nearer.",
        .stage = Stage::Shade,
    }),
};

} // namespace fumage
