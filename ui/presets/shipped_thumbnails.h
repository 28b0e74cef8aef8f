#pragma once

#include "core/scene/scene.h"

#include <QByteArray>
#include <QImage>
#include <QString>

namespace fumage::ui {

// Pictures of the built-in presets that the program brings along, so that a first start has them at once. They are
// found by the contents of the preset: one that has changed since its picture was made has none until `./dev
// thumbnails` makes it.

inline constexpr int kShippedThumbnailEdge = 256; ///< pixels

/// Names the contents of an effect: 16 hexadecimal digits.
[[nodiscard]] QString contentsOf(const Scene& scene);

/// The file of a preset's picture, in resources/thumbnails.
[[nodiscard]] QString shippedThumbnailFile(const QString& id, const Scene& scene);

/// Whether there is a picture of an effect. Some tens of microseconds.
[[nodiscard]] bool isThumbnailShipped(const Scene& scene);

/// The picture of an effect, scaled; null: there is none.
[[nodiscard]] QImage shippedThumbnail(const Scene& scene, int edge);

} // namespace fumage::ui
