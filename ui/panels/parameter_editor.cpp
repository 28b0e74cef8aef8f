#include "ui/panels/parameter_editor.h"

#include "ui/document/parameter_text.h"
#include "ui/document/text.h"
#include "ui/panels/colour_editor.h"
#include "ui/panels/curve_editor.h"
#include "ui/panels/gradient_editor.h"
#include "ui/panels/number_field.h"
#include "ui/panels/simple_editors.h"
#include "ui/panels/vector_editors.h"

#include <QLabel>

namespace fumage::ui {

ParameterEditor::ParameterEditor(const Parameter& parameter, QWidget* parent)
    : QWidget(parent)
    , m_parameter(parameter)
{
    setObjectName(toQString(parameter.key));
    setAccessibleName(fullLabelOf(parameter));
    setToolTip(toolTipOf(parameter));
}

void ParameterEditor::name(QWidget& part, const QString& suffix, const QString& spoken) const
{
    part.setObjectName(objectName() + QLatin1Char('.') + suffix);
    part.setAccessibleName(spoken.isEmpty() ? accessibleName() : accessibleName() + QLatin1Char(' ') + spoken);
    part.setAccessibleDescription(toQString(m_parameter.tip));
}

NumberField* ParameterEditor::addField(const QString& suffix, const QString& spoken)
{
    auto* field = new NumberField(NumberScale::of(m_parameter), this);
    name(*field, suffix, spoken);
    return field;
}

QWidget* ParameterEditor::makeHint(const QString& text)
{
    auto* hint = new QLabel(text, this);
    name(*hint, QStringLiteral("hint"), {});
    hint->setAccessibleName(text);
    hint->setProperty("role", QStringLiteral("hint"));
    hint->setWordWrap(true);
    return hint;
}

ParameterEditor* makeEditor(const Parameter& parameter, QWidget* parent)
{
    switch (parameter.kind) {
    case Kind::Bool: return new BoolEditor(parameter, parent);
    case Kind::Choice: return new ChoiceEditor(parameter, parent);
    case Kind::Seed: return new SeedEditor(parameter, parent);
    case Kind::Direction: return new DirectionEditor(parameter, parent);
    case Kind::Vector: return new VectorEditor(parameter, parent);
    case Kind::Colour: return new ColourEditor(parameter, parent);
    case Kind::Curve: return new CurveEditor(parameter, parent);
    case Kind::Gradient: return new GradientEditor(parameter, parent);
    case Kind::Int:
    case Kind::Float: break;
    }
    return new NumberEditor(parameter, parent);
}

} // namespace fumage::ui
