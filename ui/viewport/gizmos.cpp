#include "ui/viewport/gizmos.h"

#include "ui/viewport/navigation.h"
#include "ui/viewport/overlays.h"

#include "core/base/vector.h"
#include "core/effect/known_parameter.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <QCoreApplication>
#include <QLineF>
#include <QPainter>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace fumage::ui {

namespace {

constexpr float kSnapDegrees = 15.0F;
constexpr float kSnapMetres = 0.1F;

constexpr float kNormalPixels = 80.0F;
constexpr float kWindPixels = 110.0F;
constexpr float kVortexPixels = 140.0F;
constexpr float kLightShare = 0.36F; ///< of the shorter side of the view
constexpr double kReachPixels = 12.0; ///< how near the mouse has to be

QString gizmoText(const char* text)
{
    return QCoreApplication::translate("Gizmos", text);
}

/// Metres that a length on the screen has at a point.
float metres(const View& view, const glm::vec3& at, float pixels)
{
    constexpr float kNearest = 0.05F;
    return pixels * std::max(kNearest, project(view, at).depth) / view.focal;
}

/// Where the light's handle stands: around the middle of the picture.
glm::vec3 lightAnchor(const Effect& effect, const View& view)
{
    return effect.camera.mode == CameraMode::Orbit ? effect.camera.target
                                                   : view.eye + view.forward * effect.camera.distance;
}

float lightReach(const Effect& effect, const View& view)
{
    return metres(view, lightAnchor(effect, view), kLightShare * static_cast<float>(std::min(view.width, view.height)));
}

float snapAngle(float radians)
{
    const float step = glm::radians(kSnapDegrees);
    return std::round(radians / step) * step;
}

glm::vec3 snapDirection(const glm::vec3& direction)
{
    const float pitch = snapAngle(std::asin(std::clamp(direction.y, -1.0F, 1.0F)));
    const float yaw = snapAngle(std::atan2(direction.z, direction.x));
    return {std::cos(pitch) * std::cos(yaw), std::sin(pitch), std::cos(pitch) * std::sin(yaw)};
}

/// The direction from a centre to where the mouse meets a ball around it; beyond its rim, to the rim. The half that the
/// direction pointed to at the beginning, towards the eye or away, is the one that is met.
glm::vec3 directionOnBall(
    const View& view, const glm::vec3& centre, float radius, const glm::vec3& before, QPointF mouse)
{
    const glm::vec3 ray = rayThrough(view, mouse);
    const glm::vec3 toCentre = centre - view.eye;
    const float along = glm::dot(toCentre, ray);
    const glm::vec3 nearest = view.eye + ray * along - centre;
    const float inside = radius * radius - glm::dot(nearest, nearest);
    if (inside <= 0.0F) {
        return glm::normalize(nearest);
    }
    const bool away = glm::dot(before, view.forward) > 0.0F;
    const float half = std::sqrt(inside);
    return glm::normalize(nearest + ray * (away ? half : -half));
}

/// Where an obstacle's size is grasped: a corner of a box, the side of a ball.
glm::vec3 obstacleCorner(const Air& air, const View& view)
{
    return air.obstaclePosition
        + 0.5F * (air.obstacle == Obstacle::Sphere ? view.right * air.obstacleSize.x : air.obstacleSize);
}

std::vector<Assignment> dragObstacleSize(const Air& air, const View& view, QPointF mouse, bool snap)
{
    const glm::vec3 away = placeFacing(view, obstacleCorner(air, view), mouse, snap) - air.obstaclePosition;
    constexpr float kMin = 0.02F; // m
    const glm::vec3 size =
        air.obstacle == Obstacle::Sphere ? glm::vec3(2.0F * glm::length(away)) : 2.0F * glm::abs(away);
    return {{&knownParameter("air.obstacle_size"), glm::max(size, kMin)}};
}

/// The middle of the foot of a box of air that does not fit itself.
glm::vec3 airFoot(const Effect& effect)
{
    return effect.emitter.position + effect.air.offset;
}

glm::vec3 airCorner(const Effect& effect)
{
    return airFoot(effect) + effect.air.size * glm::vec3(0.5F, 1.0F, 0.5F);
}

glm::vec3 airLowCorner(const Effect& effect)
{
    return airFoot(effect) - effect.air.size * glm::vec3(0.5F, 0.0F, 0.5F);
}

std::vector<Assignment> dragAirSize(const Effect& effect, const View& view, QPointF mouse, bool snap)
{
    const glm::vec3 away = placeFacing(view, airCorner(effect), mouse, snap) - airFoot(effect);
    constexpr float kMin = 0.1F; // m
    return {{&knownParameter("air.size"), glm::max(glm::abs(away) * glm::vec3(2.0F, 1.0F, 2.0F), kMin)}};
}

/// Away from the axis of the rings, to the right as far as the view allows.
glm::vec3 ringSide(const glm::vec3& axis, const View& view)
{
    constexpr float kEdgeOn = 0.1F;
    const auto across = [&](const glm::vec3& way) { return way - axis * glm::dot(way, axis); };
    const glm::vec3 right = across(view.right);
    return glm::normalize(glm::length(right) > kEdgeOn ? right : across(view.up));
}

/// Radius of the ring that is one spacing away.
float ringRadius(const Rings& rings)
{
    return rings.radius + rings.widening * rings.spacing;
}

std::vector<Assignment> dragRings(const Effect& effect, const View& view, QPointF mouse, bool snap)
{
    // In the plane of the axis and the handle.
    const glm::vec3 axis = glm::normalize(effect.emitter.normal);
    const glm::vec3 side = ringSide(axis, view);
    const glm::vec3 ray = rayThrough(view, mouse);
    const glm::vec3 normal = glm::cross(axis, side);
    const float towards = glm::dot(ray, normal);
    constexpr float kEdgeOn = 1e-3F;
    if (std::abs(towards) < kEdgeOn) {
        return {};
    }
    const glm::vec3 place =
        view.eye + ray * (glm::dot(effect.emitter.position - view.eye, normal) / towards) - effect.emitter.position;
    const auto snapped = [&](float length) { return snap ? std::round(length / kSnapMetres) * kSnapMetres : length; };
    Rings rings = effect.rings;
    rings.spacing = snapped(glm::dot(place, axis));
    rings.radius = snapped(glm::dot(place, side)) - rings.widening * std::max(0.0F, rings.spacing);
    return {{&knownParameter("rings.spacing"), rings.spacing}, {&knownParameter("rings.radius"), rings.radius}};
}

std::vector<Assignment> dragWind(const Effect& effect, const View& view, QPointF mouse, bool snap)
{
    const glm::vec3 ray = rayThrough(view, mouse);
    const glm::vec3 from = effect.emitter.position;
    constexpr float kLevel = 1e-4F;
    // Seen from the side the ground is a line: then only left and right can be told.
    const float distance = std::abs(ray.y) > kLevel ? (from.y - view.eye.y) / ray.y : -1.0F;
    glm::vec3 way = distance > 0.0F
        ? view.eye + ray * distance - from
        : view.right * static_cast<float>(mouse.x() - static_cast<double>(project(view, from).x));
    way.y = 0.0F;
    if (glm::length(way) <= 0.0F) {
        return {};
    }
    float angle = std::atan2(way.z, way.x);
    angle = snap ? snapAngle(angle) : angle;
    // Whole degrees are what a hand means.
    return {{&knownParameter("wind.angle"), std::round(glm::degrees(angle))}};
}

/// Those of the air, where there is one: of its obstacle, and of its box where that does not fit itself.
void addAirGizmos(const Effect& effect, const View& view, std::vector<Gizmo>& gizmos)
{
    const Air& air = effect.air;
    if (air.enabled && air.obstacle != Obstacle::None) {
        const QColor colour(0xe0, 0xa0, 0x60);
        gizmos.push_back({GizmoId::Obstacle, air.obstaclePosition, air.obstaclePosition, colour, {}});
        gizmos.push_back({GizmoId::ObstacleSize, air.obstaclePosition, obstacleCorner(air, view), colour,
            gizmoText(QT_TRANSLATE_NOOP("Gizmos", "Obstacle"))});
    }
    if (air.enabled && !air.fit) {
        const QColor colour(0x8c, 0xbe, 0xdc);
        gizmos.push_back({GizmoId::AirPlace, airLowCorner(effect), airLowCorner(effect), colour, {}});
        gizmos.push_back({GizmoId::AirSize, airFoot(effect), airCorner(effect), colour,
            gizmoText(QT_TRANSLATE_NOOP("Gizmos", "Air"))});
    }
}

} // namespace

glm::vec3 placeFacing(const View& view, const glm::vec3& before, QPointF mouse, bool snap)
{
    const glm::vec3 ray = rayThrough(view, mouse);
    const float depth = project(view, before).depth;
    const glm::vec3 place = view.eye + ray * (depth / glm::dot(ray, view.forward));
    return snap ? glm::round(place / kSnapMetres) * kSnapMetres : place;
}

std::vector<Gizmo> gizmosOf(const Effect& effect, const View& view)
{
    const glm::vec3 emitter = effect.emitter.position;
    const auto tip = [&](const glm::vec3& direction, float pixels) {
        return emitter + direction * metres(view, emitter, pixels);
    };
    const glm::vec3 middle = lightAnchor(effect, view);
    std::vector<Gizmo> gizmos{{GizmoId::EmitterPosition, emitter, emitter, QColor(0xa8, 0xe8, 0x50),
                                  gizmoText(QT_TRANSLATE_NOOP("Gizmos", "Emitter"))},
        {GizmoId::EmitterNormal, emitter, tip(glm::normalize(effect.emitter.normal), kNormalPixels),
            QColor(0xa8, 0xe8, 0x50), gizmoText(QT_TRANSLATE_NOOP("Gizmos", "Normal"))},
        {GizmoId::Wind, emitter, tip(horizontalDirection(effect.wind.angle), kWindPixels), QColor(0x4c, 0xb8, 0xe8),
            gizmoText(QT_TRANSLATE_NOOP("Gizmos", "Wind"))
                + QStringLiteral(" θ %1°").arg(std::lround(effect.wind.angle))},
        {GizmoId::Light, middle, middle - glm::normalize(effect.light.direction) * lightReach(effect, view),
            QColor(0xff, 0xe4, 0x80), gizmoText(QT_TRANSLATE_NOOP("Gizmos", "Light"))}};
    if (effect.vortex.strength != 0.0F) {
        gizmos.push_back({GizmoId::VortexAxis, emitter, tip(glm::normalize(effect.vortex.axis), kVortexPixels),
            QColor(0xb0, 0x8c, 0xf0), gizmoText(QT_TRANSLATE_NOOP("Gizmos", "Vortex"))});
    }
    if (effect.rings.strength > 0.0F && !effect.air.enabled) { // in air they come by themselves
        const glm::vec3 axis = glm::normalize(effect.emitter.normal);
        const glm::vec3 centre = emitter + axis * effect.rings.spacing;
        gizmos.push_back({GizmoId::Rings, centre, centre + ringSide(axis, view) * ringRadius(effect.rings),
            QColor(0xf0, 0x94, 0xb4), gizmoText(QT_TRANSLATE_NOOP("Gizmos", "Rings"))});
    }
    addAirGizmos(effect, view, gizmos);
    return gizmos;
}

std::optional<GizmoId> gizmoAt(const Effect& effect, const View& view, QPointF mouse)
{
    std::optional<GizmoId> found;
    double nearest = kReachPixels;
    for (const Gizmo& gizmo : gizmosOf(effect, view)) {
        const Projected at = project(view, gizmo.to);
        const double distance = QLineF(mouse, QPointF(static_cast<double>(at.x), static_cast<double>(at.y))).length();
        if (at.depth > 0.0F && distance < nearest) {
            nearest = distance;
            found = gizmo.id;
        }
    }
    return found;
}

std::vector<Assignment> dragGizmo(GizmoId id, const Effect& effect, const View& view, QPointF mouse, bool snap)
{
    const glm::vec3 emitter = effect.emitter.position;
    const auto onBall = [&](const glm::vec3& centre, float radius, const glm::vec3& before) {
        const glm::vec3 direction = directionOnBall(view, centre, radius, before, mouse);
        return snap ? snapDirection(direction) : direction;
    };
    switch (id) {
    case GizmoId::EmitterPosition:
        return {{&knownParameter("emitter.position"), placeFacing(view, emitter, mouse, snap)}};
    case GizmoId::EmitterNormal:
        return {{&knownParameter("emitter.normal"),
            onBall(emitter, metres(view, emitter, kNormalPixels), effect.emitter.normal)}};
    case GizmoId::Wind: return dragWind(effect, view, mouse, snap);
    case GizmoId::VortexAxis:
        return {{&knownParameter("vortex.axis"),
            onBall(emitter, metres(view, emitter, kVortexPixels), effect.vortex.axis)}};
    case GizmoId::Rings: return dragRings(effect, view, mouse, snap);
    case GizmoId::Light:
        return {{&knownParameter("light.direction"),
            -onBall(lightAnchor(effect, view), lightReach(effect, view), -effect.light.direction)}};
    case GizmoId::Obstacle:
        return {
            {&knownParameter("air.obstacle_position"), placeFacing(view, effect.air.obstaclePosition, mouse, snap)}};
    case GizmoId::ObstacleSize: return dragObstacleSize(effect.air, view, mouse, snap);
    case GizmoId::AirPlace:
        return {{&knownParameter("air.offset"),
            effect.air.offset + placeFacing(view, airLowCorner(effect), mouse, snap) - airLowCorner(effect)}};
    case GizmoId::AirSize: return dragAirSize(effect, view, mouse, snap);
    }
    return {};
}

bool isOfAir(GizmoId id)
{
    return id == GizmoId::AirPlace || id == GizmoId::AirSize;
}

} // namespace fumage::ui
