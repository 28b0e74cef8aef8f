#pragma once

#include "core/export/plan.h"
#include "ui/document/document.h"
#include "ui/document/locks.h"

#include <QWidget>

#include <vector>

namespace fumage::ui {

class ParameterRow;

/// The parameters of the document that an export asks about: loop, size, quality and background.
class OutputRows : public QWidget {
public:
    OutputRows(Document& document, Locks& locks, QWidget* parent);

    /// Shows those that a plan asks about, under the names that they have there.
    void follow(const ExportPlan& plan);

private:
    [[nodiscard]] bool isAsked(const Parameter& parameter, const ExportPlan& plan) const;

    Document& m_document;
    std::vector<ParameterRow*> m_rows;
};

} // namespace fumage::ui
