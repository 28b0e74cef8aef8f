#pragma once

#include "core/effect/track.h"
#include "core/rendering/camera.h"

#include <QPointF>
#include <QRect>

#include <optional>

class QPainter;

namespace fumage::ui {

/// The way that an emitter takes: a line with a tick at each frame and a dot at each key frame.
void paintEmitterWay(QPainter& painter, const Track& way, const Timeline& timeline, const View& view);

/// @return the time of the key frame whose dot lies under the mouse, the nearest to it; none: there is none
[[nodiscard]] std::optional<double> wayKeyAt(const Track& way, const View& view, QPointF mouse);

/// Tells that each edit puts a key frame: a red ring around the picture.
void paintAutoKey(QPainter& painter, const QRect& window, const QString& text);

} // namespace fumage::ui
