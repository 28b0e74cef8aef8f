#pragma once

#include "core/effect/track.h"

#include <QIcon>

namespace fumage::ui {

/// How a value goes on from a key frame, as a picture.
[[nodiscard]] QIcon easeIcon(Ease ease, const QColor& colour);

/// A key frame that the value comes to at rest, or leaves from rest, or both, as a picture.
[[nodiscard]] QIcon levelIcon(bool in, bool out, const QColor& colour);

} // namespace fumage::ui
