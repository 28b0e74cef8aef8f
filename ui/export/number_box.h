#pragma once

#include <QString>

class QSpinBox;
class QWidget;

namespace fumage::ui {

/// A field for a whole number.
/// @param name   its objectName
/// @param spoken what screen readers and its tip say
[[nodiscard]] QSpinBox* makeNumberBox(const QString& name, const QString& spoken, int least, int most, QWidget* parent);

} // namespace fumage::ui
