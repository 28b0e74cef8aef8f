#pragma once

#include "core/scene/key_faults.h"

#include <QString>

class QMenu;

namespace fumage::ui {

class Document;

/// What the key frames of a parameter do that nobody may want, a line each; empty: nothing.
[[nodiscard]] QString keyFaultsTold(const Track& track, const Timeline& timeline);

/// Offers to mend it, an action a fault.
void addKeyMends(QMenu& menu, Document& document, const Track& track);

} // namespace fumage::ui
