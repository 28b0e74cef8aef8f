#include "ui/export/export_dialog.h"

#include "ui/document/text.h"
#include "ui/export/data_choices.h"
#include "ui/export/export_formats.h"
#include "ui/export/export_progress.h"
#include "ui/export/export_summary.h"
#include "ui/export/flipbook_choices.h"
#include "ui/export/labelled_form.h"
#include "ui/export/number_box.h"
#include "ui/export/picture_choices.h"
#include "ui/export/preview_pane.h"
#include "ui/panels/parameter_row.h"

#include "core/effect/known_parameter.h"
#include "core/effect/parameter_table.h"

#include <algorithm>
#include <array>

#include <QComboBox>
#include <QDesktopServices>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QUrl>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

/// The parameters that an export asks about.
constexpr std::array kParameters{
    &knownParameter("timeline.loop"),
    &knownParameter("output.width"),
    &knownParameter("output.height"),
    &knownParameter("output.quality"),
    &knownParameter("output.supersample"),
    &knownParameter("output.background"),
    &knownParameter("output.background_colour"),
};

} // namespace

ExportDialog::ExportDialog(Document& document, Player& player, Locks& locks, ExportQueue& queue, AskForFile askForFile, AskForChoice askForChoice, QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_player(player)
    , m_locks(locks)
    , m_queue(queue)
    , m_askForFile(std::move(askForFile))
    , m_entry(queue, std::move(askForChoice), this)
    , m_kind(new QComboBox(this))
    , m_format(new QComboBox(this))
    , m_scroll(new QScrollArea(this))
    , m_path(new QLineEdit(this))
    , m_first(makeNumberBox(QStringLiteral("export.first"), tr("First frame"), 0, kMaxFrame, this))
    , m_last(makeNumberBox(QStringLiteral("export.last"), tr("Last frame"), 0, kMaxFrame, this))
    , m_step(makeNumberBox(QStringLiteral("export.step"), tr("Every so many frames"), 1, kMaxFrame, this))
    , m_data(new DataChoices(this))
    , m_flipbook(new FlipbookChoices(this))
    , m_preview(new PreviewPane(this))
    , m_pictures(new PictureChoices(this))
    , m_files(new QLabel(this))
    , m_progress(new ExportProgress(queue, this))
    , m_export(new QPushButton(tr("Export"), this))
    , m_cancel(new QPushButton(tr("Cancel"), this))
    , m_show(new QPushButton(tr("Show in folder"), this))
{
    setObjectName(QStringLiteral("exportDialog"));
    setWindowTitle(tr("Export"));
    m_kind->setObjectName(QStringLiteral("export.kind"));
    m_kind->setAccessibleName(tr("What"));
    for (std::size_t each = 0; each < kExportKinds; ++each) {
        m_kind->addItem(kindName(static_cast<ExportKind>(each)));
    }
    m_format->setObjectName(QStringLiteral("export.format"));
    m_format->setAccessibleName(tr("Format"));
    m_path->setObjectName(QStringLiteral("export.path"));
    m_path->setAccessibleName(tr("File"));
    m_path->setToolTip(tr("A run of # becomes the number of the frame"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(12);
    buildForm();
    buildProgress();
    connectPlan();
    connectButtons();
    followKind();
    followProgress();
}

void ExportDialog::connectPlan()
{
    connect(m_kind, &QComboBox::currentIndexChanged, this, &ExportDialog::followKind);
    connect(m_format, &QComboBox::currentIndexChanged, this, &ExportDialog::followFormat);
    connect(m_path, &QLineEdit::textEdited, this, &ExportDialog::takePath);
    connect(m_path, &QLineEdit::textChanged, this, &ExportDialog::followPlan);
    for (QSpinBox* field : {m_first, m_last, m_step}) {
        connect(field, &QSpinBox::valueChanged, this, &ExportDialog::followPlan);
    }
    connect(m_data, &DataChoices::changed, this, &ExportDialog::followPlan);
    connect(m_flipbook, &FlipbookChoices::changed, this, &ExportDialog::followPlan);
    connect(m_flipbook, &FlipbookChoices::cellsChosen, this, [this](int width, int height) {
        m_document.edit({{&knownParameter("output.width"), width}, {&knownParameter("output.height"), height}}, tr("Size of cells"));
    });
    connect(m_flipbook, &FlipbookChoices::resized, this, &ExportDialog::fitScreen);
    connect(m_preview, &PreviewPane::resized, this, &ExportDialog::fitScreen);
    connect(&m_document, &Document::effectChanged, this, &ExportDialog::followPlan);
    connect(&m_document, &Document::loaded, this, [this] { m_pathIsSuggested = true; });
}

QHBoxLayout* ExportDialog::makeRange()
{
    auto* range = new QHBoxLayout;
    range->setSpacing(8);
    range->addWidget(m_first);
    range->addWidget(new QLabel(tr("to"), this));
    range->addWidget(m_last);
    range->addWidget(new QLabel(tr("every"), this));
    range->addWidget(m_step);
    range->addStretch();
    return range;
}

void ExportDialog::buildForm()
{
    auto* form = new LabelledForm;
    form->add(tr("What"), m_kind);
    form->add(tr("Format"), m_format);
    auto* place = new QHBoxLayout;
    place->setSpacing(8);
    auto* choose = new QPushButton(tr("Choose…"), this);
    choose->setObjectName(QStringLiteral("export.choose"));
    place->addWidget(m_path, 1);
    place->addWidget(choose);
    form->add(tr("File"), place);
    form->add(tr("Frames"), makeRange());
    form->addRow(m_flipbook);
    form->addRow(QString(), m_pictures);
    form->addRow(m_data);
    auto* content = new QWidget;
    auto* box = new QVBoxLayout(content);
    box->setContentsMargins({});
    box->addLayout(form);
    for (const Parameter* parameter : kParameters) {
        m_rows.push_back(new ParameterRow(*parameter, m_document, m_locks, this));
        box->addWidget(m_rows.back());
    }
    box->addWidget(m_preview);
    m_files->setObjectName(QStringLiteral("export.files"));
    m_files->setProperty("role", QStringLiteral("secondary"));
    m_files->setWordWrap(true);
    m_files->setTextFormat(Qt::PlainText);
    box->addWidget(m_files);
    box->addStretch();
    m_scroll->setObjectName(QStringLiteral("export.scroll"));
    m_scroll->setWidget(content);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    static_cast<QVBoxLayout*>(layout())->addWidget(m_scroll, 1);
    connect(choose, &QPushButton::clicked, this, &ExportDialog::browse);
}

void ExportDialog::buildProgress()
{
    m_export->setObjectName(QStringLiteral("export.begin"));
    m_export->setDefault(true);
    m_cancel->setObjectName(QStringLiteral("export.cancel"));
    m_show->setObjectName(QStringLiteral("export.show"));
    auto* close = new QPushButton(tr("Close"), this);
    close->setObjectName(QStringLiteral("export.close"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_show);
    buttons->addStretch();
    buttons->addWidget(m_cancel);
    buttons->addWidget(close);
    buttons->addWidget(m_export);
    auto* box = static_cast<QVBoxLayout*>(layout());
    box->addWidget(m_progress);
    box->addLayout(buttons);
    connect(close, &QPushButton::clicked, this, &QWidget::close);
    // Return begins an export and nothing else, also while that cannot be.
    for (QPushButton* button : findChildren<QPushButton*>()) {
        button->setAutoDefault(button == m_export);
    }
}

void ExportDialog::connectButtons()
{
    connect(m_export, &QPushButton::clicked, this, &ExportDialog::begin);
    connect(&m_entry, &ExportEntry::entered, this, &ExportDialog::followEntered);
    connect(&m_entry, &ExportEntry::refused, m_progress, &ExportProgress::say);
    connect(&m_entry, &ExportEntry::ended, this, &ExportDialog::followPlan);
    connect(&m_entry, &ExportEntry::ended, this, &ExportDialog::entryEnded);
    connect(m_cancel, &QPushButton::clicked, this, [this] { m_queue.cancel(m_queue.rowOf(m_progress->followed()->id)); });
    connect(m_show, &QPushButton::clicked, this, &ExportDialog::showInFolder);
    connect(m_progress, &ExportProgress::changed, this, &ExportDialog::followProgress);
}

ExportKind ExportDialog::kind() const
{
    return static_cast<ExportKind>(m_kind->currentIndex());
}

void ExportDialog::setKind(ExportKind kind)
{
    m_kind->setCurrentIndex(static_cast<int>(kind));
}

ExportPlan ExportDialog::plan() const
{
    ExportPlan plan;
    plan.kind = kind();
    plan.frames = {m_first->value(), m_last->value(), m_step->value()};
    plan.source = toPath(m_document.filePath());
    m_data->applyTo(plan);
    const int format = std::max(0, m_format->currentIndex());
    switch (kind()) {
    case ExportKind::Particles: plan.particles = static_cast<ParticleFormat>(format); break;
    case ExportKind::Video: plan.video = static_cast<VideoFormat>(format); break;
    case ExportKind::Air: plan.air = static_cast<AirFormat>(format); break;
    case ExportKind::Volumes: break; // there is one
    default: plan.format = static_cast<ImageFormat>(format); break;
    }
    if (kind() == ExportKind::Flipbook) {
        m_flipbook->applyTo(plan);
    }
    if (!m_path->text().trimmed().isEmpty()) {
        plan.output = withEnding(toPath(m_path->text()), fileEnding(plan));
    }
    m_pictures->applyTo(plan, m_document.preset());
    return plan;
}

void ExportDialog::followKind()
{
    const QSignalBlocker blocker(m_format);
    m_format->clear();
    m_format->addItems(formatsOf(kind()));
    if (isImage(kind())) {
        m_format->setCurrentIndex(m_imageFormat);
    }
    m_pathIsSuggested = true;
    followPlan();
    if (isVisible()) {
        fitScreen();
    }
}

void ExportDialog::followFormat()
{
    if (isImage(kind())) {
        m_imageFormat = m_format->currentIndex();
    }
    const QString path = withEndingOf(plan(), m_path->text());
    if (path.compare(m_path->text(), Qt::CaseInsensitive) != 0) {
        m_path->setText(path);
    }
    followPlan();
}

void ExportDialog::takePath(const QString& path)
{
    m_pathIsSuggested = false;
    const std::optional<int> format = formatNamedBy(path, kind());
    if (format && !path.endsWith(toQString(fileEnding(plan())), Qt::CaseInsensitive)) {
        m_format->setCurrentIndex(*format);
    }
}

void ExportDialog::followPlan()
{
    // Nobody sees it: showEvent() catches up.
    if (!isVisible()) {
        return;
    }
    const bool picture = isPicture(kind());
    const bool onColour = kind() == ExportKind::Video && !hasAlpha(plan().video);
    m_pictures->follow(plan());
    for (ParameterRow* row : m_rows) {
        row->sync();
        const bool isBehind = onColour && &row->parameter() == &knownParameter("output.background_colour");
        row->setVisible(picture && (isBehind || fumage::isVisible(row->parameter(), m_document.effect())));
    }
    m_first->setEnabled(kind() != ExportKind::NoiseTexture);
    const bool many = isNumbered(kind()) || kind() == ExportKind::Flipbook || kind() == ExportKind::Video;
    m_last->setEnabled(many);
    m_step->setEnabled(many);
    m_flipbook->setVisible(kind() == ExportKind::Flipbook);
    m_flipbook->follow(m_document.effect());
    m_data->follow(plan());
    if (m_pathIsSuggested) {
        const QSignalBlocker blocker(m_path);
        m_path->setText(suggestedPath(plan(), m_document));
    }
    const ExportPlan now = plan();
    m_files->setText(summaryOf(now, m_document.effect()));
    m_preview->setVisible(kind() == ExportKind::Flipbook);
    if (kind() == ExportKind::Flipbook) {
        m_flipbook->followPlan(m_document.effect(), now);
        m_preview->follow(m_document.effect(), now);
    }
    m_export->setEnabled(!m_entry.isBusy() && isPossible(now, m_document.effect()));
}

void ExportDialog::followProgress()
{
    const QueuedExport* last = m_progress->followed();
    m_cancel->setVisible(last != nullptr && last->isActive());
    m_show->setVisible(last != nullptr && last->state == ExportState::Done);
}

void ExportDialog::begin()
{
    m_entry.enter({m_document.displayName().toStdString(), m_document.preset(), plan()});
    followPlan();
}

void ExportDialog::followEntered(quint64 id, const ExportPlan& plan, std::optional<OnClash> answered)
{
    if (answered == OnClash::NumberOn) {
        m_pathIsSuggested = false;
        m_path->setText(fromPath(plan.output));
    }
    m_progress->follow(id);
    emit added(plan);
}

void ExportDialog::browse()
{
    const QString chosen = m_askForFile(this, {.purpose = FileQuestion::Purpose::Save, .title = tr("Export to"), .start = m_path->text(), .mayReplace = true});
    if (!chosen.isEmpty()) {
        m_pathIsSuggested = false;
        m_path->setText(chosen);
        takePath(chosen);
    }
}

void ExportDialog::showInFolder()
{
    QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(fromPath(m_progress->followed()->job->plan.output)).path()));
}

void ExportDialog::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    if (const QueuedExport* last = m_progress->followed(); last == nullptr || !last->isActive()) {
        m_first->setValue(m_player.first());
        m_last->setValue(m_player.last());
        m_progress->follow(0);
    }
    followPlan();
    fitScreen();
    emit shownChanged(true);
}

void ExportDialog::fitScreen()
{
    constexpr QSize kMargin(32 + 16, 48); // of the layout with a scroll bar; of the window
    const QSize content = m_scroll->widget()->minimumSizeHint();
    const int wanted = sizeHint().height() - m_scroll->sizeHint().height() + m_scroll->widget()->sizeHint().height();
    resize(std::max(width(), content.width() + kMargin.width()), std::min(wanted, screen()->availableGeometry().height() - kMargin.height()));
}

void ExportDialog::hideEvent(QHideEvent* event)
{
    QDialog::hideEvent(event);
    emit shownChanged(false);
}

} // namespace fumage::ui
