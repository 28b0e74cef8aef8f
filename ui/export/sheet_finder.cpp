#include "ui/export/sheet_finder.h"

#include "ui/export/export_summary.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHideEvent>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr double kBytesAMegabyte = 1024.0 * 1024.0;

} // namespace

SheetFinder::SheetFinder(QWidget* parent)
    : QWidget(parent)
    , m_budget(new QDoubleSpinBox(this))
    , m_find(new QPushButton(this))
    , m_state(new QLabel(this))
{
    build();
    end({});
    connect(m_find, &QPushButton::clicked, this, [this] { m_isSearching ? end(tr("Cancelled.")) : begin(); });
    connect(&m_search, &SheetSearch::progressed, this,
        [this](double share) { m_state->setText(tr("Trying sheets: %1 %").arg(static_cast<int>(100.0 * share))); });
    connect(&m_search, &SheetSearch::found, this, &SheetFinder::take);
    connect(&m_search, &SheetSearch::failed, this, &SheetFinder::end);
}

void SheetFinder::build()
{
    constexpr double kMin = 0.1;
    constexpr double kMax = 1024.0;
    constexpr double kUsual = 4.0;
    m_budget->setObjectName(QStringLiteral("export.budget"));
    m_budget->setAccessibleName(tr("Memory on the graphics card"));
    m_budget->setToolTip(tr("What all pictures of the flipbook may take there, as BC7"));
    m_budget->setRange(kMin, kMax);
    m_budget->setDecimals(1);
    m_budget->setSuffix(tr(" MiB"));
    m_budget->setValue(kUsual);
    m_find->setObjectName(QStringLiteral("export.findSheet"));
    m_find->setAutoDefault(false);
    m_state->setObjectName(QStringLiteral("export.findSheet.state"));
    m_state->setProperty("role", QStringLiteral("secondary"));
    m_state->setWordWrap(true);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(new QLabel(tr("Fit to a memory budget"), this));
    row->addWidget(m_budget);
    row->addWidget(m_find);
    row->addStretch();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addLayout(row);
    layout->addWidget(m_state);
}

void SheetFinder::follow(const Scene& scene, const ExportPlan& plan)
{
    const bool isSame = !m_isSearching
        || (scene == m_wanted->scene && haveSameCells(m_wanted->plan, plan) && m_wanted->plan.passes == plan.passes
            && m_wanted->plan.layers == plan.layers && m_wanted->plan.flipbook.packs == plan.flipbook.packs);
    if (!isSame) {
        end(tr("Cancelled: the flipbook has changed."));
    }
    m_wanted = {scene, plan};
}

void SheetFinder::begin()
{
    if (!m_wanted) {
        return;
    }
    Scene scene = m_wanted->scene;
    const bool isAsChosen = m_taken && scene.output.width == m_taken->width && scene.output.height == m_taken->height;
    if (!isAsChosen) {
        m_largest = scene.output;
    }
    // A size that was found for another budget is no bound.
    scene.output.width = m_largest.width;
    scene.output.height = m_largest.height;
    m_isSearching = true;
    m_find->setText(tr("Cancel"));
    m_state->setText(tr("Trying sheets…"));
    m_state->show();
    emit resized();
    m_search.start(scene, m_wanted->plan, static_cast<std::int64_t>(m_budget->value() * kBytesAMegabyte));
}

void SheetFinder::end(const QString& said)
{
    m_isSearching = false;
    m_search.stop();
    m_find->setText(tr("Optimise"));
    m_find->setToolTip(
        tr("Tries columns, rows and sizes of cells, and takes those that play nearest to the animation"));
    m_state->setText(said);
    m_state->setVisible(!said.isEmpty());
    emit resized();
}

void SheetFinder::take(const SheetCandidate& best)
{
    m_taken = best;
    const QLocale locale;
    end(tr("%1 × %2 cells of %3 × %4 pixels, %5: %6 dB")
            .arg(best.columns)
            .arg(best.rows)
            .arg(best.width)
            .arg(best.height)
            .arg(locale.formattedDataSize(best.bytes, 1), locale.toString(best.decibels, 'f', 1)));
    emit chosen(best);
}

void SheetFinder::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    if (m_isSearching && !event->spontaneous()) {
        end(tr("Cancelled."));
    }
}

} // namespace fumage::ui
