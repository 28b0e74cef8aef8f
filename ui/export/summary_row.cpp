#include "ui/export/summary_row.h"

#include "ui/document/key_edits.h"

#include "core/scene/key_faults.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace fumage::ui {

SummaryRow::SummaryRow(Document& document, QWidget* parent)
    : QWidget(parent)
    , m_files(new QLabel(this))
    , m_solo(new QLabel(this))
    , m_offer(new QPushButton(this))
    , m_mendKeys(new QPushButton(tr("Mend key frames"), this))
{
    m_files->setObjectName(QStringLiteral("export.files"));
    m_files->setProperty("role", QStringLiteral("secondary"));
    m_files->setWordWrap(true);
    m_files->setTextFormat(Qt::PlainText);
    m_solo->setObjectName(QStringLiteral("export.solo"));
    m_solo->setWordWrap(true);
    m_solo->setTextFormat(Qt::PlainText);
    m_solo->hide();
    m_offer->setObjectName(QStringLiteral("export.offer"));
    m_offer->hide();
    m_mendKeys->setObjectName(QStringLiteral("export.mendKeys"));
    m_mendKeys->setToolTip(
        tr("Moves key frames into the timeline, closes loops, and lets rates change smoothly: one undo step"));
    m_mendKeys->hide();
    auto* box = new QVBoxLayout(this);
    box->setContentsMargins({});
    box->addWidget(m_solo);
    box->addWidget(m_files);
    box->addWidget(m_offer, 0, Qt::AlignLeft);
    box->addWidget(m_mendKeys, 0, Qt::AlignLeft);
    connect(m_mendKeys, &QPushButton::clicked, this, [&document] { mendKeys(document); });
    connect(m_offer, &QPushButton::clicked, this, [this] {
        if (m_offered) {
            emit taken(ExportOffer(*m_offered)); // a copy: it becomes another while its parts are taken
        }
    });
}

void SummaryRow::follow(const ExportPlan& plan, const Scene& scene, bool solo)
{
    m_solo->setText(tr("Solo is of the view only. Layers that are exported: %1.").arg(scene.visibleLayers().size()));
    m_solo->setVisible(solo);
    m_files->setText(summaryOf(plan, scene));
    m_offered = offerFor(plan, scene);
    m_offer->setText(m_offered ? m_offered->text : QString());
    m_offer->setVisible(m_offered.has_value());
    m_mendKeys->setVisible(hasKeyFaults(scene));
}

} // namespace fumage::ui
