#include "ui/export/number_box.h"

#include "ui/widgets/plain_text.h"

#include "ui/panels/whole_box.h"

namespace fumage::ui {

QSpinBox* makeNumberBox(const QString& name, const QString& spoken, int least, int most, QWidget* parent)
{
    auto* field = new WholeBox(parent);
    field->setObjectName(name);
    field->setAccessibleName(spoken);
    field->setToolTip(plainToolTip(spoken));
    field->setRange(least, most);
    return field;
}

} // namespace fumage::ui
