#pragma once

#include "core/export/plan.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QSpinBox;

namespace fumage::ui {

/// What only some kinds of exports are asked: how videos play, how fine data are, and which axis points up in them.
class DataChoices : public QWidget {
    Q_OBJECT

public:
    explicit DataChoices(QWidget* parent = nullptr);

    /// Shows what the kind and the format of a plan ask for, and itself where that is anything.
    void follow(const ExportPlan& plan);
    /// Writes them into a plan, whose kind is set.
    void applyTo(ExportPlan& plan) const;
    /// Shows what a plan that is remembered says.
    void take(const ExportPlan& plan);

signals:
    void changed();

private:
    void buildVideo();
    void buildVolumes();
    void showRow(QWidget* field, bool shown);

    QFormLayout* m_form;
    QComboBox* m_rate; ///< the first: the timeline's
    QComboBox* m_repeat;
    QSpinBox* m_noiseSize; ///< 0: the effect's own
    QSpinBox* m_cells;
    QDoubleSpinBox* m_voxel; ///< 0: as many as there are cells
    QComboBox* m_up;
    QComboBox* m_density;
};

} // namespace fumage::ui
