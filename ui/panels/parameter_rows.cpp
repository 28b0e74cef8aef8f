#include "ui/panels/parameter_rows.h"

#include <QVBoxLayout>

namespace fumage::ui {

ParameterRows::ParameterRows(std::span<const Parameter* const> parameters, const QString& prefix, Document& document,
    Locks& locks, QWidget* parent)
    : QWidget(parent)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    for (const Parameter* parameter : parameters) {
        auto* row = new ParameterRow(*parameter, document, locks, this);
        row->prefixNames(prefix);
        layout->addWidget(row);
        m_rows.push_back(row);
    }
    connect(&document, &Document::effectChanged, this, &ParameterRows::sync);
    connect(&document, &Document::titleChanged, this, &ParameterRows::sync);
    sync();
}

void ParameterRows::sync()
{
    for (ParameterRow* row : m_rows) {
        row->sync();
    }
}

} // namespace fumage::ui
