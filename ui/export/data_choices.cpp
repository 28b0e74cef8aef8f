#include "ui/export/data_choices.h"

#include "ui/export/labelled_form.h"
#include "ui/export/number_box.h"

#include "core/noise/texture.h"

#include <QComboBox>
#include <QSpinBox>

namespace fumage::ui {

namespace {

/// Whether a plan's files have axes that one may choose.
bool hasUpAxis(const ExportPlan& plan)
{
    return plan.kind == ExportKind::Volumes || (plan.kind == ExportKind::Particles && plan.particles != ParticleFormat::Pcache);
}

} // namespace

DataChoices::DataChoices(QWidget* parent)
    : QWidget(parent)
    , m_noiseSize(makeNumberBox(QStringLiteral("export.noiseSize"), tr("Size of the noise texture"), 0, kMaxTextureSize, this))
    , m_cells(makeNumberBox(QStringLiteral("export.cells"), tr("Cells along the longest edge"), kMinVolumeCells, kMaxVolumeCells, this))
    , m_up(new QComboBox(this))
{
    m_noiseSize->setSpecialValueText(tr("as in the effect"));
    m_noiseSize->setSuffix(tr(" pixels"));
    m_cells->setValue(ExportPlan().cells);
    m_up->setObjectName(QStringLiteral("export.up"));
    m_up->setAccessibleName(tr("Axis that points up"));
    m_up->addItems({tr("As usual for the format"), tr("y, as in Houdini and Maya"), tr("z, as in Blender")});
    auto* form = new LabelledForm(this);
    form->setContentsMargins({});
    form->add(tr("Size"), m_noiseSize);
    form->add(tr("Cells"), m_cells);
    form->add(tr("Up"), m_up);
    m_form = form;
    connect(m_noiseSize, &QSpinBox::valueChanged, this, &DataChoices::changed);
    connect(m_cells, &QSpinBox::valueChanged, this, &DataChoices::changed);
    connect(m_up, &QComboBox::currentIndexChanged, this, &DataChoices::changed);
}

void DataChoices::showRow(QWidget* field, bool shown)
{
    field->setVisible(shown);
    m_form->labelForField(field)->setVisible(shown);
}

void DataChoices::follow(const ExportPlan& plan)
{
    showRow(m_noiseSize, plan.kind == ExportKind::NoiseTexture);
    showRow(m_cells, plan.kind == ExportKind::Volumes);
    showRow(m_up, hasUpAxis(plan));
    setVisible(plan.kind == ExportKind::NoiseTexture || hasUpAxis(plan));
}

void DataChoices::applyTo(ExportPlan& plan) const
{
    plan.noiseSize = m_noiseSize->value();
    plan.cells = m_cells->value();
    plan.up = m_up->currentIndex() == 0 ? std::nullopt : std::optional(kAllUpAxes[static_cast<std::size_t>(m_up->currentIndex()) - 1]);
}

} // namespace fumage::ui
