#pragma once

#include "ui/panels/parameter_row.h"

#include <span>
#include <vector>

namespace fumage::ui {

/// A few parameters outside of their panel, one below the other; follows the document by itself.
class ParameterRows : public QWidget {
    Q_OBJECT

public:
    /// @param prefix of all objectNames: the editors in the panel have the names without it
    ParameterRows(std::span<const Parameter* const> parameters, const QString& prefix, Document& document, Locks& locks,
        QWidget* parent = nullptr);

private:
    void sync();

    std::vector<ParameterRow*> m_rows;
};

} // namespace fumage::ui
