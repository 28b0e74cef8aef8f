#include "ui/export/picture_choices.h"

#include "ui/widgets/decimal_box.h"

#include "core/export/fit_camera.h"
#include "core/export/manifest/manifest_parts.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

/// Whether there is room for masks of layers.
bool mayHaveMasks(const ExportPlan& plan)
{
    const bool isTogether = plan.layers.value_or(LayerOutput::Together) == LayerOutput::Together;
    return canBeRecorded(plan.kind) && holdsFloats(plan.format) && isTogether;
}

} // namespace

PictureChoices::PictureChoices(QWidget* parent)
    : QWidget(parent)
    , m_fit(new QCheckBox(tr("Fit the camera to the smoke of all frames"), this))
    , m_outliers(new DecimalBox(this))
    , m_carries(new QCheckBox(tr("Embed the preset in pictures"), this))
    , m_manifest(new QCheckBox(tr("Write a manifest of checksums"), this))
    , m_masks(new QCheckBox(tr("Write a mask of each layer"), this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    buildFit(*layout);
    m_carries->setObjectName(QStringLiteral("export.carries"));
    m_carries->setToolTip(tr("Fumage then opens a picture as the preset that it was made of, at its frame"));
    m_carries->setChecked(true);
    m_manifest->setObjectName(QStringLiteral("export.manifest"));
    m_manifest->setToolTip(tr("A file beside the others with what each of them shows: Verify, in the panel Exports, "
                              "and fumage-cli verify then find those that are missing, broken or changed"));
    m_masks->setObjectName(QStringLiteral("export.masks"));
    m_masks->setToolTip(tr("Channels of an EXR that say how much of each layer is seen: together they are its alpha"));
    connect(m_masks, &QCheckBox::toggled, this, &PictureChoices::changed);
    for (QCheckBox* choice : {m_carries, m_manifest, m_masks}) {
        layout->addWidget(choice);
    }
}

void PictureChoices::buildFit(QVBoxLayout& layout)
{
    constexpr int kIndent = 24; // pixels; about as far as the text of the switch above
    constexpr double kStep = 0.5; // percent
    m_fit->setObjectName(QStringLiteral("export.fit"));
    m_fit->setToolTip(tr("Pictures are taken from where all smoke is seen and fills them; the view stays as it is"));
    auto* label = new QLabel(tr("Ignore outliers"), this);
    label->setBuddy(m_outliers);
    m_outliers->setObjectName(QStringLiteral("export.outliers"));
    m_outliers->setAccessibleName(tr("Ignore outliers"));
    m_outliers->setToolTip(
        tr("How much of the smoke may be outside, such as stray sparks, so that the rest is larger"));
    m_outliers->setRange(0.0, static_cast<double>(kMaxOutlierPercent));
    m_outliers->setDecimals(2);
    m_outliers->setSingleStep(kStep);
    m_outliers->setSuffix(tr(" %"));
    layout.addWidget(m_fit);
    auto* row = new QHBoxLayout;
    row->addSpacing(kIndent);
    row->addWidget(label);
    row->addWidget(m_outliers);
    row->addStretch();
    layout.addLayout(row);
    for (QWidget* each : {static_cast<QWidget*>(label), static_cast<QWidget*>(m_outliers)}) {
        each->setEnabled(false);
        connect(m_fit, &QCheckBox::toggled, each, &QWidget::setEnabled);
    }
}

void PictureChoices::follow(const ExportPlan& plan)
{
    setVisible(isPicture(plan.kind));
    m_carries->setVisible(isPicture(plan.kind) && plan.kind != ExportKind::Video && plan.format != ImageFormat::Tga);
    m_manifest->setVisible(canBeRecorded(plan.kind));
    m_masks->setVisible(canBeRecorded(plan.kind));
    m_masks->setEnabled(m_hasLayers && mayHaveMasks(plan));
}

void PictureChoices::applyTo(ExportPlan& plan, const Preset& preset) const
{
    plan.fitCamera = m_fit->isChecked();
    plan.outlierPercent = static_cast<float>(m_outliers->value());
    if (m_carries->isChecked()) {
        plan.project = preset;
    }
    if (m_manifest->isChecked() && canBeRecorded(plan.kind)) {
        plan.recording.manifest = manifestBeside(plan.output);
    }
    if (m_masks->isChecked() && m_hasLayers && mayHaveMasks(plan)) {
        plan.passes.add(Pass::LayerMasks);
    }
}

void PictureChoices::take(const ExportPlan& plan)
{
    if (isPicture(plan.kind)) {
        m_fit->setChecked(plan.fitCamera);
        m_outliers->setValue(static_cast<double>(plan.outlierPercent));
        m_carries->setChecked(plan.project.has_value());
    }
    if (mayHaveMasks(plan)) {
        m_masks->setChecked(plan.passes.has(Pass::LayerMasks));
    }
    if (canBeRecorded(plan.kind)) {
        m_manifest->setChecked(!plan.recording.manifest.empty());
    }
}

void PictureChoices::setFitsCamera(bool fits)
{
    m_fit->setChecked(fits);
}

} // namespace fumage::ui
