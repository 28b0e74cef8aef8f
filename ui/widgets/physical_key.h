#pragma once

#include <optional>

class QKeyEvent;

namespace fumage::ui {

/// The digit or letter that lies on a keyboard of the United States where a key was pressed, for shortcuts: the keys of
/// digits give other signs on a French keyboard, and those of letters other letters on a Cyrillic one.
/// @return a Qt::Key; nothing where the key gives a Latin letter or a digit itself, or its place is not known
[[nodiscard]] std::optional<int> physicalKey(const QKeyEvent& event);

} // namespace fumage::ui
