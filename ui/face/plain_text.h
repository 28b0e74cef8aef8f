#pragma once

#include <QString>

namespace fumage::ui {

/// A tool tip that shows a text as it is. Qt takes what looks like HTML for HTML and loads what it names, and names, paths and messages come
/// from files that may hold anything.
[[nodiscard]] QString plainToolTip(const QString& text);

} // namespace fumage::ui
