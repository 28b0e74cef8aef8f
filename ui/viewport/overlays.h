#pragma once

#include "ui/preview/picture.h"

#include <QLineF>
#include <QObject>
#include <QRectF>

#include <optional>
#include <vector>

class QPainter;

namespace fumage::ui {

/// What can be drawn over the smoke.
enum class Overlay {
    Grid = 1,
    Emitter = 2,
    Gizmos = 4,
    Trails = 8,
    Frame = 16,
    Readout = 32,
    Air = 64,
};
Q_DECLARE_FLAGS(Overlays, Overlay)
Q_DECLARE_OPERATORS_FOR_FLAGS(Overlays)

/// A line in space on the screen, cut off where it passes the eye; nothing where all of it lies behind.
[[nodiscard]] std::optional<QLineF> projectLine(const View& view, glm::vec3 from, glm::vec3 to);

void paintGrid(QPainter& painter, const View& view);
/// The outline of an emitter on the screen.
[[nodiscard]] std::vector<QLineF> emitterOutline(const Emitter& emitter, const View& view);
void paintEmitter(QPainter& painter, const Emitter& emitter, const View& view);
/// The emitters of layers that are not edited, thin.
void paintOtherEmitters(
    QPainter& painter, const Scene& scene, const std::vector<std::size_t>& layers, const View& view);
/// Which of the layers has the outline under the mouse, the nearest to it.
[[nodiscard]] std::optional<std::size_t> emitterAt(
    const Scene& scene, const std::vector<std::size_t>& layers, const View& view, QPointF mouse);
/// With the painter's pen. @param normal of the circle's plane
void paintCircle(QPainter& painter, const glm::vec3& centre, const glm::vec3& normal, float radius, const View& view);
/// Figure 2 of the 2012 model: the ways of particles, in green.
void paintTrails(QPainter& painter, const std::vector<Trail>& trails, const View& view);
/// The box of the air.
void paintAirBox(QPainter& painter, const Scene& scene, const View& view);
/// The obstacle in it, if there is one.
void paintObstacle(QPainter& painter, const Air& air, const View& view);
/// What the air does: arrows as long as it goes in a tenth of a second, at most to the next one; warm air is orange.
void paintAir(QPainter& painter, const std::vector<AirArrow>& arrows, const View& view);
/// The frame that is exported, with what lies outside of it dimmed.
void paintFrame(QPainter& painter, const QRectF& frame, const QRectF& window, const QString& label);

} // namespace fumage::ui
