#include "ui/viewport/animation_overlay.h"

#include "ui/viewport/overlays.h"

#include <QLineF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace fumage::ui {

void paintEmitterWay(QPainter& painter, const Track& way, const Timeline& timeline, const View& view)
{
    constexpr QColor kColour(240, 180, 60, 200);
    constexpr int kMaxFrames = 2000; // of a long timeline the beginning is seen
    const auto placeAt = [&](double seconds) { return std::get<glm::vec3>(way.at(seconds)); };
    const auto dotAt = [&](double seconds, double radius) {
        const Projected at = project(view, placeAt(seconds));
        if (at.depth > 0.0F) {
            painter.drawEllipse(QPointF(static_cast<double>(at.x), static_cast<double>(at.y)), radius, radius);
        }
    };
    const int frames = std::min(kMaxFrames, timeline.length);
    painter.setPen(QPen(kColour, 1.2));
    for (int frame = 1; frame < frames; ++frame) {
        const double from = static_cast<double>(frame - 1) / timeline.frameRate;
        const double to = static_cast<double>(frame) / timeline.frameRate;
        const std::optional<QLineF> line = projectLine(view, placeAt(from), placeAt(to));
        if (line && !way.jumpsIn(from, to)) {
            painter.drawLine(*line);
        }
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(kColour);
    for (int frame = 0; frame < frames; ++frame) {
        dotAt(static_cast<double>(frame) / timeline.frameRate, 1.5);
    }
    for (const KeyFrame& key : way.keys) {
        dotAt(key.seconds, 4.0);
    }
    painter.setBrush(Qt::NoBrush);
}

std::optional<double> wayKeyAt(const Track& way, const View& view, QPointF mouse)
{
    constexpr double kReach = 8.0; // pixels
    std::optional<double> found;
    double nearest = kReach;
    for (const KeyFrame& key : way.keys) {
        const Projected at = project(view, std::get<glm::vec3>(key.value));
        const double away = QLineF(mouse, QPointF(static_cast<double>(at.x), static_cast<double>(at.y))).length();
        if (at.depth > 0.0F && away < nearest) {
            nearest = away;
            found = key.seconds;
        }
    }
    return found;
}

void paintAutoKey(QPainter& painter, const QRect& window, const QString& text)
{
    constexpr QColor kRed(220, 50, 40);
    constexpr int kWidth = 3;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(kRed, kWidth));
    painter.drawRect(QRectF(window).adjusted(1.5, 1.5, -1.5, -1.5));
    painter.drawText(window.adjusted(0, 8, -12, 0), Qt::AlignRight | Qt::AlignTop, text);
}

} // namespace fumage::ui
