#include "ui/viewport/overlays.h"

#include "core/base/vector.h"
#include "core/simulation/air_plan.h"

#include <algorithm>
#include <cmath>

#include <QPainter>
#include <QPainterPath>

#include <glm/geometric.hpp>

namespace fumage::ui {

namespace {

constexpr int kGridHalf = 10; ///< lines to each side, 1 m apart
constexpr int kOutlineCorners = 48;

void drawLine(QPainter& painter, const View& view, const glm::vec3& from, const glm::vec3& to)
{
    if (const std::optional<QLineF> line = projectLine(view, from, to)) {
        painter.drawLine(*line);
    }
}

void drawLoop(QPainter& painter, const View& view, const std::vector<glm::vec3>& corners)
{
    for (std::size_t i = 0; i < corners.size(); ++i) {
        drawLine(painter, view, corners[i], corners[(i + 1) % corners.size()]);
    }
}

std::vector<glm::vec3> circle(const glm::vec3& centre, const glm::vec3& u, const glm::vec3& v)
{
    std::vector<glm::vec3> corners;
    for (int i = 0; i < kOutlineCorners; ++i) {
        const float angle = 6.2831853F * static_cast<float>(i) / static_cast<float>(kOutlineCorners);
        corners.push_back(centre + u * std::cos(angle) + v * std::sin(angle));
    }
    return corners;
}

void drawBox(QPainter& painter, const View& view, const glm::vec3& low, const glm::vec3& high)
{
    const auto corner = [&](unsigned bits) {
        return glm::vec3(
            (bits & 1U) != 0 ? high.x : low.x, (bits & 2U) != 0 ? high.y : low.y, (bits & 4U) != 0 ? high.z : low.z);
    };
    for (unsigned from = 0; from < 8; ++from) {
        for (const unsigned axis : {1U, 2U, 4U}) {
            if ((from & axis) == 0) {
                drawLine(painter, view, corner(from), corner(from | axis));
            }
        }
    }
}

void drawBall(QPainter& painter, const View& view, const glm::vec3& centre, float radius)
{
    const glm::vec3 x(radius, 0.0F, 0.0F);
    const glm::vec3 y(0.0F, radius, 0.0F);
    const glm::vec3 z(0.0F, 0.0F, radius);
    drawLoop(painter, view, circle(centre, x, y));
    drawLoop(painter, view, circle(centre, y, z));
    drawLoop(painter, view, circle(centre, z, x));
}

} // namespace

std::optional<QLineF> projectLine(const View& view, glm::vec3 from, glm::vec3 to)
{
    constexpr float kNearest = 0.02F;
    const float a = glm::dot(from - view.eye, view.forward);
    const float b = glm::dot(to - view.eye, view.forward);
    if (a < kNearest && b < kNearest) {
        return std::nullopt;
    }
    const auto cut = [&] { return from + (to - from) * ((kNearest - a) / (b - a)); };
    if (a < kNearest) {
        from = cut();
    } else if (b < kNearest) {
        to = cut();
    }
    const Projected start = project(view, from);
    const Projected end = project(view, to);
    return QLineF(static_cast<double>(start.x), static_cast<double>(start.y), static_cast<double>(end.x),
        static_cast<double>(end.y));
}

void paintGrid(QPainter& painter, const View& view)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    constexpr auto kReach = static_cast<float>(kGridHalf);
    for (int i = -kGridHalf; i <= kGridHalf; ++i) {
        const auto at = static_cast<float>(i);
        const int strength = i == 0 ? 0 : 34;
        painter.setPen(QPen(i == 0 ? QColor(216, 92, 84, 150) : QColor(200, 205, 215, strength), 1.0));
        drawLine(painter, view, {-kReach, 0.0F, at}, {kReach, 0.0F, at});
        painter.setPen(QPen(i == 0 ? QColor(88, 134, 226, 150) : QColor(200, 205, 215, strength), 1.0));
        drawLine(painter, view, {at, 0.0F, -kReach}, {at, 0.0F, kReach});
    }
    painter.restore();
}

std::vector<QLineF> emitterOutline(const Emitter& emitter, const View& view)
{
    std::vector<QLineF> lines;
    const auto addLoop = [&](const std::vector<glm::vec3>& corners) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if (const auto line = projectLine(view, corners[i], corners[(i + 1) % corners.size()])) {
                lines.push_back(*line);
            }
        }
    };
    const glm::vec3 normal = glm::normalize(emitter.normal);
    const PlaneBasis basis = planeBasis(normal);
    const glm::vec3 centre = emitter.position;
    if (isRectangular(emitter)) {
        const glm::vec3 u = basis.across * (0.5F * emitter.width);
        const glm::vec3 v = basis.along * (0.5F * emitter.depth);
        addLoop({centre - u - v, centre + u - v, centre + u + v, centre - u + v});
    } else {
        addLoop(circle(centre, basis.across * emitter.radius, basis.along * emitter.radius));
    }
    if (emitter.shape == EmitterShape::Sphere) {
        addLoop(circle(centre, basis.across * emitter.radius, normal * emitter.radius));
        addLoop(circle(centre, basis.along * emitter.radius, normal * emitter.radius));
    }
    return lines;
}

void paintEmitter(QPainter& painter, const Emitter& emitter, const View& view)
{
    const std::vector<QLineF> lines = emitterOutline(emitter, view);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(0xa8, 0xe8, 0x50, 210), 1.6));
    painter.drawLines(lines.data(), static_cast<int>(lines.size()));
    painter.restore();
}

void paintOtherEmitters(QPainter& painter, const Scene& scene, const std::vector<std::size_t>& layers, const View& view)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(200, 205, 215, 130), 1.0));
    for (const std::size_t layer : layers) {
        const std::vector<QLineF> lines = emitterOutline(scene.layers[layer].emitter, view);
        painter.drawLines(lines.data(), static_cast<int>(lines.size()));
    }
    painter.restore();
}

std::optional<std::size_t> emitterAt(
    const Scene& scene, const std::vector<std::size_t>& layers, const View& view, QPointF mouse)
{
    constexpr double kReach = 5.0; // pixels
    double nearest = kReach;
    std::optional<std::size_t> found;
    for (const std::size_t layer : layers) {
        for (const QLineF& line : emitterOutline(scene.layers[layer].emitter, view)) {
            const QPointF way = line.p2() - line.p1();
            const double length = QPointF::dotProduct(way, way);
            const double at =
                length > 0.0 ? std::clamp(QPointF::dotProduct(mouse - line.p1(), way) / length, 0.0, 1.0) : 0.0;
            const double distance = QLineF(mouse, line.p1() + at * way).length();
            if (distance < nearest) {
                nearest = distance;
                found = layer;
            }
        }
    }
    return found;
}

void paintCircle(QPainter& painter, const glm::vec3& centre, const glm::vec3& normal, float radius, const View& view)
{
    const PlaneBasis basis = planeBasis(normal);
    drawLoop(painter, view, circle(centre, basis.across * radius, basis.along * radius));
}

void paintTrails(QPainter& painter, const std::vector<Trail>& trails, const View& view)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(80, 220, 110, 170), 1.2));
    for (const Trail& trail : trails) {
        for (std::size_t i = 1; i < trail.size(); ++i) {
            drawLine(painter, view, trail[i - 1], trail[i]);
        }
    }
    painter.restore();
}

void paintAirBox(QPainter& painter, const Scene& scene, const View& view)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(140, 190, 220, 130), 1.0));
    const AirGrid grid = airGrid(sampledLayers(scene));
    drawBox(painter, view, grid.corner, grid.end());
    painter.restore();
}

void paintObstacle(QPainter& painter, const Air& air, const View& view)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(0xe0, 0xa0, 0x60, 220), 1.4));
    if (air.obstacle == Obstacle::Box) {
        drawBox(painter, view, air.obstaclePosition - 0.5F * air.obstacleSize,
            air.obstaclePosition + 0.5F * air.obstacleSize);
    } else if (air.obstacle == Obstacle::Sphere) {
        drawBall(painter, view, air.obstaclePosition, 0.5F * air.obstacleSize.x);
    }
    painter.restore();
}

void paintAir(QPainter& painter, const std::vector<AirArrow>& arrows, const View& view)
{
    constexpr float kSeconds = 0.1F;
    constexpr float kLongest = 1.2F; // gaps
    const auto mixed = [](int cold, int warm, float heat) {
        return static_cast<int>(std::lround(static_cast<float>(cold) + static_cast<float>(warm - cold) * heat));
    };
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const AirArrow& arrow : arrows) {
        const float length = glm::length(arrow.velocity) * kSeconds;
        const glm::vec3 way =
            arrow.velocity * kSeconds * (length > kLongest * arrow.gap ? kLongest * arrow.gap / length : 1.0F);
        const std::optional<QLineF> line = projectLine(view, arrow.place - 0.5F * way, arrow.place + 0.5F * way);
        constexpr double kSeen = 1.5; // pixels: air that stands still has no arrow
        if (!line || line->length() < kSeen) {
            continue;
        }
        const float heat = std::clamp(arrow.heat, 0.0F, 1.0F);
        const QColor colour(mixed(120, 255, heat), mixed(190, 140, heat), mixed(240, 40, heat), mixed(150, 230, heat));
        painter.setPen(QPen(colour, 1.2));
        painter.drawLine(*line);
        painter.setPen(QPen(colour, 3.0, Qt::SolidLine, Qt::RoundCap)); // its head
        painter.drawPoint(line->p2());
    }
    painter.restore();
}

void paintFrame(QPainter& painter, const QRectF& frame, const QRectF& window, const QString& label)
{
    painter.save();
    QPainterPath outside;
    outside.addRect(window);
    QPainterPath inside;
    inside.addRect(frame);
    painter.fillPath(outside.subtracted(inside), QColor(0, 0, 0, 90));
    painter.setPen(QPen(QColor(255, 255, 255, 120), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(frame.adjusted(0.5, 0.5, -0.5, -0.5));
    painter.drawText(frame.adjusted(8.0, 6.0, -8.0, -6.0), Qt::AlignBottom | Qt::AlignRight, label);
    painter.restore();
}

} // namespace fumage::ui
