#pragma once

#include "core/export/plan.h"

#include <QWidget>

class QComboBox;
class QFormLayout;
class QSpinBox;

namespace fumage::ui {

/// What only exports that are no pictures of the smoke are asked: how fine they are, and which axis points up.
class DataChoices : public QWidget {
    Q_OBJECT

public:
    explicit DataChoices(QWidget* parent = nullptr);

    /// Shows what the kind and the format of a plan ask for, and itself where that is anything.
    void follow(const ExportPlan& plan);
    /// Writes them into a plan, whose kind is set.
    void applyTo(ExportPlan& plan) const;

signals:
    void changed();

private:
    void showRow(QWidget* field, bool shown);

    QFormLayout* m_form;
    QSpinBox* m_noiseSize; ///< 0: the effect's own
    QSpinBox* m_cells;
    QComboBox* m_up;
};

} // namespace fumage::ui
