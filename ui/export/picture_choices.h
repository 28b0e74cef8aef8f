#pragma once

#include "core/export/plan.h"

#include <QWidget>

class QCheckBox;

namespace fumage::ui {

/// What only pictures of the smoke are asked: how the camera stands, what they carry, and whether there is a manifest
/// to verify them by.
class PictureChoices : public QWidget {
    Q_OBJECT

public:
    explicit PictureChoices(QWidget* parent = nullptr);

    /// Shows what the kind and the format of a plan ask for.
    void follow(const ExportPlan& plan);
    /// Writes them into a plan, whose kind and output are set.
    /// @param preset that pictures carry
    void applyTo(ExportPlan& plan, const Preset& preset) const;
    /// Shows what a plan that is remembered says.
    void take(const ExportPlan& plan);
    void setFitsCamera(bool fits);

private:
    QCheckBox* m_fit;
    QCheckBox* m_carries;
    QCheckBox* m_manifest;
};

} // namespace fumage::ui
