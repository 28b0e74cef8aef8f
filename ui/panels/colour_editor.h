#pragma once

#include "ui/panels/parameter_editor.h"

#include <QColor>

#include <array>
#include <functional>

class QColorDialog;
class QToolButton;

namespace fumage::ui {

/// A colour of linear light as the screen shows it; brighter than white is cut off.
[[nodiscard]] QColor screenColour(const glm::vec3& linear);
[[nodiscard]] glm::vec3 linearColour(const QColor& screen);

/// Lets a person choose a colour; changes are seen at once.
/// @param parent  hears a DragCancel, and what is around it, before what was changed is taken back
/// @param changed called with each colour, and at the end with the one that was accepted, or with the one before, where
///                there was another meanwhile
/// @return the dialog, which deletes itself
QColorDialog& chooseColour(QWidget* parent, const QString& title, const glm::vec3& before,
    const std::function<void(const glm::vec3&, bool finished)>& changed);

/// A swatch that opens a colour dialog.
class ColourEditor : public ParameterEditor {
    Q_OBJECT

public:
    ColourEditor(const Parameter& parameter, QWidget* parent);
    void setValue(const Value& value) override;

private:
    void showValue();

    QToolButton* m_swatch;
    std::array<NumberField*, 3> m_fields{};
    glm::vec3 m_value{1.0F};
};

} // namespace fumage::ui
