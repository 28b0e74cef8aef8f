#include "ui/export/flipbook_choices.h"

#include "ui/document/text.h"
#include "ui/export/flipbook_extras.h"
#include "ui/export/labelled_form.h"
#include "ui/export/number_box.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>

namespace fumage::ui {

namespace {

QHBoxLayout* sideBySide(std::initializer_list<QWidget*> widgets)
{
    auto* box = new QHBoxLayout;
    box->setSpacing(8);
    for (QWidget* widget : widgets) {
        box->addWidget(widget);
    }
    box->addStretch();
    return box;
}

} // namespace

FlipbookChoices::FlipbookChoices(QWidget* parent)
    : QWidget(parent)
    , m_engine(new QComboBox(this))
    , m_layers(new QComboBox(this))
    , m_sixWay(new QCheckBox(tr("Light maps"), this))
    , m_motion(new QCheckBox(tr("Motion vectors"), this))
    , m_columns(makeNumberBox(QStringLiteral("export.columns"), tr("Columns"), 1, kMaxSheetCells, this))
    , m_rows(makeNumberBox(QStringLiteral("export.rows"), tr("Rows"), 1, kMaxSheetCells, this))
    , m_extras(new FlipbookExtras(this))
{
    m_engine->setObjectName(QStringLiteral("export.engine"));
    m_engine->setAccessibleName(tr("For"));
    m_engine->setToolTip(tr("What is to play it: the files that it needs are written, too"));
    for (const Engine each : kAllEngines) {
        m_engine->addItem(each == Engine::Generic ? tr("Any engine")
                : each == Engine::Web             ? tr("Web page")
                                                  : toQString(titleOf(each)));
    }
    m_layers->setObjectName(QStringLiteral("export.layers"));
    m_layers->setAccessibleName(tr("Layers"));
    m_layers->addItems({tr("Together"), tr("Each alone"), tr("Contributions"), tr("Stacked")});
    m_layers->setToolTip(tr("Together: one sheet. Each alone: a sheet a layer that nothing hides. Contributions: the "
                            "others hide what they hide, and all sheets add up to the picture. Stacked: sheets that "
                            "are the picture when they are drawn over one another, premultiplied."));
    m_sixWay->setObjectName(QStringLiteral("export.sixWay"));
    m_sixWay->setToolTip(
        tr("Two pictures with light from six sides, so that an engine lights the smoke with its own lights"));
    m_motion->setObjectName(QStringLiteral("export.motion"));
    m_motion->setToolTip(tr("A picture of where the smoke goes, so that an engine moves it between the cells"));
    const FlipbookPlan usual;
    m_columns->setValue(usual.columns);
    m_rows->setValue(usual.rows);
    auto* form = new LabelledForm(this);
    form->setContentsMargins({});
    form->add(tr("For"), m_engine);
    form->add(tr("Layers"), m_layers);
    form->add(tr("Extra maps"), sideBySide({m_sixWay, m_motion}));
    form->add(tr("Grid"), sideBySide({m_columns, new QLabel(QStringLiteral("×"), this), m_rows}));
    form->addRow(m_extras);
    connect(m_engine, &QComboBox::currentIndexChanged, this, &FlipbookChoices::followEngine);
    connect(m_layers, &QComboBox::currentIndexChanged, this, &FlipbookChoices::followLayers);
    connect(m_sixWay, &QCheckBox::toggled, this, &FlipbookChoices::changed);
    connect(m_motion, &QCheckBox::toggled, this, &FlipbookChoices::changed);
    connect(m_columns, &QSpinBox::valueChanged, this, &FlipbookChoices::changed);
    connect(m_rows, &QSpinBox::valueChanged, this, &FlipbookChoices::changed);
    connect(m_extras, &FlipbookExtras::sheetChosen, this, &FlipbookChoices::takeSheet);
    connect(m_extras, &FlipbookExtras::changed, this, &FlipbookChoices::changed);
    connect(m_extras, &FlipbookExtras::resized, this, &FlipbookChoices::resized);
}

Engine FlipbookChoices::engine() const
{
    return kAllEngines[static_cast<std::size_t>(m_engine->currentIndex())];
}

LayerOutput FlipbookChoices::layers() const
{
    return m_layers->isEnabled() ? static_cast<LayerOutput>(m_layers->currentIndex()) : LayerOutput::Together;
}

/// Shares have no maps.
void FlipbookChoices::followLayers()
{
    m_sixWay->setEnabled(!isShare(layers()));
    m_motion->setEnabled(!isShare(layers()));
    emit changed();
}

void FlipbookChoices::followEngine()
{
    const PassSet passes = passesFor(engine());
    {
        const QSignalBlocker sixWay(m_sixWay);
        const QSignalBlocker motion(m_motion);
        m_sixWay->setChecked(passes.has(Pass::SixWayA));
        m_motion->setChecked(passes.has(Pass::Motion));
    }
    emit changed();
}

void FlipbookChoices::applyTo(ExportPlan& plan) const
{
    plan.flipbook.engine = engine();
    plan.passes = {Pass::Colour};
    if (layers() != LayerOutput::Together) {
        plan.layers = layers();
    }
    const bool hasMaps = !isShare(layers());
    if (hasMaps && m_sixWay->isChecked()) {
        plan.passes.add(Pass::SixWayA);
        plan.passes.add(Pass::SixWayB);
    }
    if (hasMaps && m_motion->isChecked()) {
        plan.passes.add(Pass::Motion);
    }
    plan.style = styleFor(plan.flipbook.engine, plan.format);
    plan.flipbook.columns = m_columns->value();
    plan.flipbook.rows = m_rows->value();
    m_extras->applyTo(plan);
}

void FlipbookChoices::setGrid(int columns, int rows)
{
    {
        const QSignalBlocker one(m_columns);
        const QSignalBlocker other(m_rows);
        m_columns->setValue(columns);
        m_rows->setValue(rows);
    }
    emit changed();
}

void FlipbookChoices::takeSheet(const SheetCandidate& sheet)
{
    emit cellsChosen(sheet.width, sheet.height);
    setGrid(sheet.columns, sheet.rows);
}

void FlipbookChoices::take(const ExportPlan& plan)
{
    if (plan.kind != ExportKind::Flipbook) {
        return;
    }
    m_engine->setCurrentIndex(
        static_cast<int>(std::ranges::find(kAllEngines, plan.flipbook.engine) - kAllEngines.begin()));
    m_layers->setCurrentIndex(static_cast<int>(plan.layers.value_or(LayerOutput::Together)));
    m_sixWay->setChecked(plan.passes.has(Pass::SixWayA));
    m_motion->setChecked(plan.passes.has(Pass::Motion));
    m_extras->take(plan);
    setGrid(plan.flipbook.columns, plan.flipbook.rows);
}

void FlipbookChoices::follow(const Scene& scene)
{
    const bool several = scene.layers.size() > 1;
    if (several != m_layers->isEnabled()) {
        m_layers->setEnabled(several);
        followLayers();
    }
    m_extras->follow(scene);
}

void FlipbookChoices::followPlan(const Scene& scene, const ExportPlan& plan)
{
    m_extras->followPlan(scene, plan);
}

} // namespace fumage::ui
