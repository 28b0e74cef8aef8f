#include "ui/export/picture_choices.h"

#include "core/export/manifest/manifest_parts.h"

#include <QCheckBox>
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
    , m_carries(new QCheckBox(tr("Embed the preset in pictures"), this))
    , m_manifest(new QCheckBox(tr("Write a manifest of checksums"), this))
    , m_masks(new QCheckBox(tr("Write a mask of each layer"), this))
{
    m_fit->setObjectName(QStringLiteral("export.fit"));
    m_fit->setToolTip(tr("Pictures are taken from where all smoke is seen and fills them; the view stays as it is"));
    m_carries->setObjectName(QStringLiteral("export.carries"));
    m_carries->setToolTip(tr("Fumage then opens a picture as the preset that it was made of, at its frame"));
    m_carries->setChecked(true);
    m_manifest->setObjectName(QStringLiteral("export.manifest"));
    m_manifest->setToolTip(tr("A file beside the others with what each of them shows: Verify, in the panel Exports, "
                              "and fumage-cli verify then find those that are missing, broken or changed"));
    m_masks->setObjectName(QStringLiteral("export.masks"));
    m_masks->setToolTip(tr("Channels of an EXR that say how much of each layer is seen: together they are its alpha"));
    connect(m_masks, &QCheckBox::toggled, this, &PictureChoices::changed);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    for (QCheckBox* choice : {m_fit, m_carries, m_manifest, m_masks}) {
        layout->addWidget(choice);
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
