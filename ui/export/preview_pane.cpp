#include "ui/export/preview_pane.h"

#include "ui/export/export_summary.h"
#include "ui/export/labelled_form.h"
#include "ui/export/preview_canvas.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr int kTick = 33; ///< ms between two pictures
constexpr int kSettle = 400; ///< ms

} // namespace

PreviewPane::PreviewPane(std::shared_ptr<AirCache> shelf, QWidget* parent)
    : QWidget(parent)
    , m_job(std::move(shelf))
    , m_body(new QWidget(this))
    , m_canvas(new PreviewCanvas(this))
    , m_blending(new QComboBox(this))
    , m_backdrop(new QComboBox(this))
    , m_state(new QLabel(this))
{
    setObjectName(QStringLiteral("export.preview"));
    auto* plays = new QCheckBox(tr("Play as in the engine"), this);
    plays->setObjectName(QStringLiteral("export.plays"));
    auto* form = new LabelledForm(this);
    form->setContentsMargins({});
    form->add(tr("Preview"), plays);
    form->addRow(m_body);
    m_body->hide();
    connect(plays, &QCheckBox::toggled, this, [this](bool on) {
        m_body->setVisible(on);
        on ? wake() : rest();
        emit resized();
    });
    buildBody();
    m_settle.setSingleShot(true);
    m_settle.setInterval(kSettle);
    m_tick.setInterval(kTick);
    connect(&m_settle, &QTimer::timeout, this, &PreviewPane::render);
    connect(&m_tick, &QTimer::timeout, this, &PreviewPane::play);
    connectJob();
}

void PreviewPane::buildBody()
{
    m_canvas->setObjectName(QStringLiteral("export.preview.canvas"));
    m_blending->setObjectName(QStringLiteral("export.preview.blending"));
    m_blending->setAccessibleName(tr("Between cells"));
    m_blending->setToolTip(tr("What the engine does between two cells"));
    m_blending->addItems({tr("No blending"), tr("Cross-fade")});
    m_blending->setCurrentIndex(static_cast<int>(CellBlending::CrossFade));
    m_backdrop->setObjectName(QStringLiteral("export.preview.backdrop"));
    m_backdrop->setAccessibleName(tr("Background"));
    m_backdrop->addItems({tr("Dark"), tr("Light"), tr("Checkerboard")});
    m_state->setObjectName(QStringLiteral("export.preview.state"));
    m_state->setProperty("role", QStringLiteral("secondary"));
    m_state->setWordWrap(true);
    auto* side = new QVBoxLayout;
    side->setSpacing(8);
    side->addWidget(m_blending);
    side->addWidget(m_backdrop);
    side->addWidget(m_state);
    side->addStretch();
    auto* row = new QHBoxLayout(m_body);
    row->setContentsMargins({});
    row->setSpacing(12);
    row->addWidget(m_canvas);
    row->addLayout(side, 1);
    connect(m_backdrop, &QComboBox::currentIndexChanged, m_canvas,
        [this](int index) { m_canvas->setBackdrop(static_cast<PreviewCanvas::Backdrop>(index)); });
}

void PreviewPane::connectJob()
{
    connect(&m_job, &PreviewJob::progressed, this, [this](int percent) {
        const QString text = tr("Rendering the cells: %1 %").arg(percent);
        if (m_preview) {
            m_state->setText(text); // the last one goes on playing
        } else {
            m_canvas->say(text);
        }
    });
    connect(&m_job, &PreviewJob::ready, this, &PreviewPane::take);
    connect(&m_job, &PreviewJob::failed, this, [this](const QString& message) {
        m_preview.reset();
        m_canvas->say(message);
    });
}

void PreviewPane::follow(const Scene& scene, const ExportPlan& plan)
{
    if (m_wanted && m_wanted->scene == scene && haveSameCells(m_wanted->plan, plan)) {
        return;
    }
    m_wanted = {scene, plan};
    m_isStale = true;
    followMotion();
    if (isPlaying()) {
        m_settle.start();
    }
}

void PreviewPane::followMotion()
{
    const bool hasMotion = m_wanted->plan.passes.has(Pass::Motion);
    const bool showsMotion = m_blending->count() > static_cast<int>(CellBlending::Motion);
    if (hasMotion && !showsMotion) {
        m_blending->addItem(tr("Motion vectors"));
        m_blending->setCurrentIndex(static_cast<int>(CellBlending::Motion));
    } else if (!hasMotion && showsMotion) {
        m_blending->removeItem(static_cast<int>(CellBlending::Motion));
    }
}

void PreviewPane::render()
{
    if (!isPossible(m_wanted->plan, m_wanted->scene)) {
        m_job.stop();
        m_preview.reset();
        m_canvas->say({});
        return;
    }
    if (!m_preview) {
        m_canvas->say(tr("Rendering the cells…"));
    }
    m_job.start(m_wanted->scene, m_wanted->plan);
}

void PreviewPane::take(const std::shared_ptr<const SheetPreview>& preview)
{
    m_preview = preview;
    m_isStale = false;
    m_clock.start();
    const SheetGrid& grid = preview->sheet.grid;
    m_state->setText(preview->isWhole ? tr("%1 cells a second").arg(QLocale().toString(preview->cellsPerSecond, 'f', 1))
                                      : tr("%1 cells a second, shown at %2 × %3 pixels")
                                            .arg(QLocale().toString(preview->cellsPerSecond, 'f', 1))
                                            .arg(grid.cellWidth)
                                            .arg(grid.cellHeight));
    play();
}

void PreviewPane::play()
{
    if (!m_preview) {
        return;
    }
    constexpr double kMillisecondsASecond = 1000.0;
    m_canvas->setImage(m_frame.at(*m_preview, static_cast<double>(m_clock.elapsed()) / kMillisecondsASecond,
        static_cast<CellBlending>(m_blending->currentIndex())));
}

void PreviewPane::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (isPlaying()) {
        wake();
    }
}

void PreviewPane::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    rest();
}

void PreviewPane::wake()
{
    m_tick.start();
    if (m_wanted && m_isStale) {
        render();
    }
}

void PreviewPane::rest()
{
    m_tick.stop();
    m_settle.stop();
    m_job.stop();
}

} // namespace fumage::ui
