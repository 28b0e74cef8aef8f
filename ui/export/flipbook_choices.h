#pragma once

#include "core/export/plan.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QSpinBox;

namespace fumage::ui {

class FlipbookExtras;

/// What only flipbooks are asked: what plays them, their passes, and how many cells they have.
class FlipbookChoices : public QWidget {
    Q_OBJECT

public:
    explicit FlipbookChoices(QWidget* parent = nullptr);

    /// What cannot be chosen for this effect is out of reach.
    void follow(const Effect& effect);
    /// Writes them into a plan, whose format says how light is stored.
    void applyTo(ExportPlan& plan) const;

signals:
    void changed();
    /// It takes more room, or less.
    void resized();

private:
    void followEngine();
    [[nodiscard]] Engine engine() const;

    QComboBox* m_engine;
    QCheckBox* m_sixWay;
    QCheckBox* m_motion;
    QSpinBox* m_columns;
    QSpinBox* m_rows;
    FlipbookExtras* m_extras;
};

} // namespace fumage::ui
