#include "ui/export/data_choices.h"

#include "ui/document/text.h"
#include "ui/export/labelled_form.h"
#include "ui/export/number_box.h"
#include "ui/widgets/decimal_box.h"

#include "core/noise/texture.h"

#include <algorithm>
#include <array>

#include <QComboBox>
#include <QLocale>
#include <QSpinBox>

namespace fumage::ui {

namespace {

/// Those of film, television and screens.
constexpr std::array kRates{FrameRate{24000, 1001}, FrameRate{24, 1}, FrameRate{25, 1}, FrameRate{30000, 1001},
    FrameRate{30, 1}, FrameRate{50, 1}, FrameRate{60000, 1001}, FrameRate{60, 1}};

/// Whether a plan's files have axes that one may choose.
bool hasUpAxis(const ExportPlan& plan)
{
    return plan.kind == ExportKind::Volumes
        || (plan.kind == ExportKind::Particles && plan.particles != ParticleFormat::Pcache);
}

} // namespace

DataChoices::DataChoices(QWidget* parent)
    : QWidget(parent)
    , m_rate(new QComboBox(this))
    , m_repeat(new QComboBox(this))
    , m_noiseSize(
          makeNumberBox(QStringLiteral("export.noiseSize"), tr("Size of the noise texture"), 0, kMaxTextureSize, this))
    , m_cells(makeNumberBox(QStringLiteral("export.cells"),
          tr("Voxels along the longest edge of the smoke of the whole timeline"), kMinVolumeCells, kMaxVolumeCells,
          this))
    , m_voxel(new DecimalBox(this))
    , m_up(new QComboBox(this))
    , m_density(new QComboBox(this))
{
    m_noiseSize->setSpecialValueText(tr("as in the effect"));
    m_noiseSize->setSuffix(tr(" pixels"));
    m_up->setObjectName(QStringLiteral("export.up"));
    m_up->setAccessibleName(tr("Axis that points up"));
    m_up->addItems({tr("As usual for the format"), tr("y, as in Houdini and Maya"), tr("z, as in Blender")});
    m_density->setObjectName(QStringLiteral("export.density"));
    m_density->setAccessibleName(tr("Density"));
    m_density->setToolTip(tr("One grid of all layers, or one of each, which add up to it"));
    m_density->addItems({tr("Of all layers"), tr("A grid a layer")});
    buildVideo();
    buildVolumes();
    auto* form = new LabelledForm(this);
    form->setContentsMargins({});
    form->add(tr("Frame rate"), m_rate);
    form->add(tr("Repeat"), m_repeat);
    form->add(tr("Size"), m_noiseSize);
    form->add(tr("Voxels"), m_cells);
    form->add(tr("Voxel size"), m_voxel);
    form->add(tr("Density"), m_density);
    form->add(tr("Up axis"), m_up);
    m_form = form;
    connect(m_noiseSize, &QSpinBox::valueChanged, this, &DataChoices::changed);
    connect(m_cells, &QSpinBox::valueChanged, this, &DataChoices::changed);
    connect(m_voxel, &QDoubleSpinBox::valueChanged, this, &DataChoices::changed);
    for (QComboBox* choice : {m_rate, m_repeat, m_up, m_density}) {
        connect(choice, &QComboBox::currentIndexChanged, this, &DataChoices::changed);
    }
}

void DataChoices::buildVideo()
{
    m_rate->setObjectName(QStringLiteral("export.rate"));
    m_rate->setAccessibleName(tr("Frame rate"));
    m_rate->setToolTip(tr("Frames a second at which the video plays; the frames stay the same"));
    m_rate->addItem(tr("As the timeline"));
    for (const FrameRate& rate : kRates) {
        m_rate->addItem(QLocale().toString(rate.perSecond(), 'g', 5), toQString(textOf(rate)));
    }
    m_repeat->setObjectName(QStringLiteral("export.repeat"));
    m_repeat->setAccessibleName(tr("Repeat"));
    m_repeat->addItems({tr("For ever if the frames close a loop"), tr("Once"), tr("For ever")});
}

void DataChoices::buildVolumes()
{
    constexpr int kDecimals = 4;
    m_cells->setValue(VolumePlan().cells);
    m_voxel->setObjectName(QStringLiteral("export.voxel"));
    m_voxel->setAccessibleName(tr("Voxel size"));
    m_voxel->setToolTip(tr("Edge of a voxel; all frames have the same"));
    m_voxel->setDecimals(kDecimals);
    m_voxel->setRange(0.0, static_cast<double>(kMaxVoxel));
    m_voxel->setSingleStep(0.01);
    m_voxel->setSuffix(tr(" m"));
    m_voxel->setSpecialValueText(tr("by their number"));
}

void DataChoices::showRow(QWidget* field, bool shown)
{
    field->setVisible(shown);
    m_form->labelForField(field)->setVisible(shown);
}

void DataChoices::follow(const ExportPlan& plan)
{
    const bool isVideo = plan.kind == ExportKind::Video;
    showRow(m_rate, isVideo);
    showRow(m_repeat, isVideo && saysHowOften(plan.video.format));
    showRow(m_noiseSize, plan.kind == ExportKind::NoiseTexture);
    showRow(m_cells, plan.kind == ExportKind::Volumes);
    m_cells->setEnabled(!plan.volume.voxel);
    showRow(m_voxel, plan.kind == ExportKind::Volumes);
    showRow(m_density, plan.kind == ExportKind::Volumes);
    showRow(m_up, hasUpAxis(plan));
    setVisible(isVideo || plan.kind == ExportKind::NoiseTexture || hasUpAxis(plan));
}

void DataChoices::applyTo(ExportPlan& plan) const
{
    plan.noise.size = m_noiseSize->value();
    plan.volume.cells = m_cells->value();
    plan.volume.voxel = m_voxel->value() > 0.0 ? std::optional(static_cast<float>(m_voxel->value())) : std::nullopt;
    plan.volume.density = static_cast<DensityGrids>(m_density->currentIndex());
    plan.video.rate = m_rate->currentIndex() > 0
        ? std::optional(kRates[static_cast<std::size_t>(m_rate->currentIndex()) - 1])
        : std::nullopt;
    plan.video.repeat = static_cast<Repeat>(m_repeat->currentIndex());
    plan.up = m_up->currentIndex() == 0 ? std::nullopt
                                        : std::optional(kAllUpAxes[static_cast<std::size_t>(m_up->currentIndex()) - 1]);
}

void DataChoices::take(const ExportPlan& plan)
{
    switch (plan.kind) {
    case ExportKind::NoiseTexture: m_noiseSize->setValue(plan.noise.size); break;
    case ExportKind::Video:
        m_rate->setCurrentIndex(
            plan.video.rate ? std::max(0, m_rate->findData(toQString(textOf(*plan.video.rate)))) : 0);
        m_repeat->setCurrentIndex(static_cast<int>(plan.video.repeat));
        break;
    case ExportKind::Volumes:
        m_cells->setValue(plan.volume.cells);
        m_voxel->setValue(static_cast<double>(plan.volume.voxel.value_or(0.0F)));
        m_density->setCurrentIndex(static_cast<int>(plan.volume.density));
        m_up->setCurrentIndex(plan.up ? 1 + static_cast<int>(*plan.up) : 0);
        break;
    default: break;
    }
}

} // namespace fumage::ui
