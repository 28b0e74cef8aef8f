#pragma once

#include "core/effect/track.h"

#include <QIcon>

namespace fumage::ui {

/// How a value goes on from a key frame, as a picture.
[[nodiscard]] QIcon easeIcon(Ease ease, const QColor& colour);

} // namespace fumage::ui
