#pragma once

#include "core/export/plan.h"

#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;
class QVBoxLayout;

namespace fumage::ui {

/// What only pictures of the smoke are asked: how the camera stands, what they carry, whether there is a manifest to
/// verify them by, and whether an EXR has a mask of each layer.
class PictureChoices : public QWidget {
    Q_OBJECT

public:
    explicit PictureChoices(QWidget* parent = nullptr);

    /// Shows what the kind and the format of a plan ask for.
    void follow(const ExportPlan& plan);
    /// Whether there are several layers; of one there is nothing to mask. follow() shows it.
    void setHasLayers(bool several) { m_hasLayers = several; }
    /// Writes them into a plan, whose kind and output are set.
    /// @param preset that pictures carry
    void applyTo(ExportPlan& plan, const Preset& preset) const;
    /// Shows what a plan that is remembered says.
    void take(const ExportPlan& plan);
    void setFitsCamera(bool fits);

signals:
    /// Other files are written, or what they hold.
    void changed();

private:
    void buildFit(QVBoxLayout& layout);

    QCheckBox* m_fit;
    QDoubleSpinBox* m_outliers; ///< percent
    QCheckBox* m_carries;
    QCheckBox* m_manifest;
    QCheckBox* m_masks;
    bool m_hasLayers = false;
};

} // namespace fumage::ui
