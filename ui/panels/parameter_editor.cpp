#include "ui/panels/parameter_editor.h"

#include "ui/document/parameter_text.h"
#include "ui/document/text.h"
#include "ui/panels/number_field.h"

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

} // namespace fumage::ui
