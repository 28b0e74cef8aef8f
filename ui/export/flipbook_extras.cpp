#include "ui/export/flipbook_extras.h"

#include "ui/export/labelled_form.h"
#include "ui/export/pack_row.h"
#include "ui/export/sheet_finder.h"
#include "ui/panels/curve_editor.h"

#include <algorithm>

#include <QCheckBox>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace fumage::ui {

FlipbookExtras::FlipbookExtras(QWidget* parent)
    : QWidget(parent)
    , m_more(new QToolButton(this))
    , m_content(new QWidget(this))
    , m_trim(new QCheckBox(tr("Trim empty frames"), this))
    , m_powerOfTwo(new QCheckBox(tr("Power-of-two sheet"), this))
    , m_retimes(new QCheckBox(tr("Retime with a curve"), this))
    , m_curve(new CurveArea(this))
    , m_finder(new SheetFinder(this))
    , m_add(new QPushButton(tr("Add channel-packed texture"), this))
{
    m_more->setObjectName(QStringLiteral("export.more"));
    m_more->setText(tr("More"));
    m_more->setCheckable(true);
    m_more->setAutoRaise(true);
    m_more->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_trim->setObjectName(QStringLiteral("export.trim"));
    m_powerOfTwo->setObjectName(QStringLiteral("export.powerOfTwo"));
    m_powerOfTwo->setToolTip(
        tr("Cells become as large as the nearest power of two; with 1, 2, 4 to 64 columns and rows"));
    m_retimes->setObjectName(QStringLiteral("export.retimes"));
    m_retimes->setToolTip(tr("From left to right through the cells, from bottom to top through the frames: level is "
                             "still, falling is backwards"));
    m_curve->setObjectName(QStringLiteral("export.retime"));
    m_curve->setAccessibleName(tr("Frames by cells"));
    m_curve->setCurve(Curve{{0.0F, 0.0F}, {1.0F, 1.0F}});
    m_curve->hide();
    m_add->setObjectName(QStringLiteral("export.addPack"));
    m_add->setToolTip(tr("A picture whose channels are those of passes that you choose"));
    m_add->setAutoDefault(false);
    build();
    setOpen(false);
    connect(m_more, &QToolButton::toggled, this, &FlipbookExtras::setOpen);
    connect(m_trim, &QCheckBox::toggled, this, &FlipbookExtras::changed);
    connect(m_powerOfTwo, &QCheckBox::toggled, this, &FlipbookExtras::changed);
    connect(m_curve, &CurveArea::changed, this, &FlipbookExtras::changed);
    connect(m_add, &QPushButton::clicked, this, &FlipbookExtras::addPack);
    connect(m_finder, &SheetFinder::chosen, this, &FlipbookExtras::sheetChosen);
    connect(m_finder, &SheetFinder::resized, this, &FlipbookExtras::resized);
    connect(m_retimes, &QCheckBox::toggled, this, [this](bool on) {
        m_curve->setVisible(on);
        emit changed();
        emit resized();
    });
}

void FlipbookExtras::build()
{
    auto* content = new QVBoxLayout(m_content);
    content->setContentsMargins(LabelledForm::kFieldLeft, 0, 0, 0); // below the fields of other rows
    content->addWidget(m_trim);
    content->addWidget(m_powerOfTwo);
    content->addWidget(m_retimes);
    content->addWidget(m_curve);
    content->addWidget(m_finder);
    m_list = new QVBoxLayout;
    m_list->setSpacing(8);
    content->addLayout(m_list);
    content->addWidget(m_add, 0, Qt::AlignLeft);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(m_more);
    layout->addWidget(m_content);
}

void FlipbookExtras::setOpen(bool open)
{
    m_more->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    m_content->setVisible(open);
    emit resized();
}

PackRow* FlipbookExtras::addPack()
{
    auto* row = new PackRow(++m_packsEver, this);
    m_packs.push_back(row);
    m_list->addWidget(row);
    connect(row, &PackRow::changed, this, &FlipbookExtras::changed);
    connect(row, &PackRow::removed, this, [this, row] { removePack(row); });
    m_add->setEnabled(m_packs.size() < kMaxPackedPictures);
    emit changed();
    emit resized();
    return row;
}

void FlipbookExtras::take(const ExportPlan& plan)
{
    m_trim->setChecked(plan.flipbook.trim);
    m_powerOfTwo->setChecked(plan.flipbook.powerOfTwo);
    if (plan.flipbook.retime) {
        m_curve->setCurve(*plan.flipbook.retime);
    }
    m_retimes->setChecked(plan.flipbook.retime.has_value());
    while (!m_packs.empty()) {
        removePack(m_packs.back());
    }
    for (const PackedPicture& pack : plan.flipbook.packs) {
        addPack()->take(pack);
    }
}

void FlipbookExtras::removePack(PackRow* row)
{
    std::erase(m_packs, row);
    m_list->removeWidget(row);
    row->hide();
    row->deleteLater();
    m_add->setEnabled(true);
    emit changed();
    emit resized();
}

void FlipbookExtras::followPlan(const Scene& scene, const ExportPlan& plan)
{
    m_finder->follow(scene, plan);
}

void FlipbookExtras::follow(const Scene& scene)
{
    m_trim->setEnabled(!scene.timeline.loop);
    m_trim->setToolTip(scene.timeline.loop ? tr("Not of a loop, which would no longer close")
                                           : tr("Frames without smoke at the beginning and the end have no cells"));
}

void FlipbookExtras::applyTo(ExportPlan& plan) const
{
    plan.flipbook.trim = m_trim->isEnabled() && m_trim->isChecked();
    plan.flipbook.powerOfTwo = m_powerOfTwo->isChecked();
    if (m_retimes->isChecked()) {
        plan.flipbook.retime = m_curve->curve();
    }
    for (const PackRow* row : m_packs) {
        plan.flipbook.packs.push_back(row->pack());
    }
}

} // namespace fumage::ui
