#pragma once

class QWidget;

namespace fumage::ui {

/// Whether a part of a widget is to be seen in its window: it is shown, and not scrolled away. What lies over it does
/// not count.
[[nodiscard]] bool isInSight(const QWidget& widget);

} // namespace fumage::ui
