#pragma once

#include "core/export/sheets/sheet_optimizer.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QSpinBox;

namespace fumage::ui {

class FlipbookExtras;

/// What only flipbooks are asked: what plays them, their layers and passes, and how many cells they have.
class FlipbookChoices : public QWidget {
    Q_OBJECT

public:
    explicit FlipbookChoices(QWidget* parent = nullptr);

    /// What cannot be chosen for this effect is out of reach.
    void follow(const Scene& scene);
    /// What is to be written, applyTo() included: a search for a sheet begins with it.
    void followPlan(const Scene& scene, const ExportPlan& plan);
    /// Writes them into a plan, whose format says how light is stored.
    void applyTo(ExportPlan& plan) const;
    /// Shows what a plan that is remembered says.
    void take(const ExportPlan& plan);
    void setGrid(int columns, int rows);

signals:
    void changed();
    /// The cells are to have another size, pixels.
    void cellsChosen(int width, int height);
    /// It takes more room, or less.
    void resized();

private:
    void followEngine();
    void followLayers();
    void takeSheet(const SheetCandidate& sheet);
    [[nodiscard]] Engine engine() const;
    [[nodiscard]] LayerOutput layers() const;

    QComboBox* m_engine;
    QComboBox* m_layers;
    QCheckBox* m_sixWay;
    QCheckBox* m_motion;
    QSpinBox* m_columns;
    QSpinBox* m_rows;
    FlipbookExtras* m_extras;
};

} // namespace fumage::ui
