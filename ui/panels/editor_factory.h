#pragma once

#include "ui/panels/parameter_editor.h"

namespace fumage::ui {

/// @return the editor for the parameter's kind
[[nodiscard]] ParameterEditor* makeEditor(const Parameter& parameter, QWidget* parent);

} // namespace fumage::ui
