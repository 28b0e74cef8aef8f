#include "ui/export/export_dialog.h"

#include "ui/document/text.h"
#include "ui/export/data_choices.h"
#include "ui/export/export_formats.h"
#include "ui/export/export_progress.h"
#include "ui/export/flipbook_choices.h"
#include "ui/export/labelled_form.h"
#include "ui/export/output_rows.h"
#include "ui/export/picture_choices.h"
#include "ui/export/preview_pane.h"
#include "ui/export/range_row.h"
#include "ui/export/show_folder.h"
#include "ui/export/summary_row.h"

#include "core/effect/known_parameter.h"

#include <algorithm>

#include <QComboBox>
#include <QDir>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace fumage::ui {

ExportDialog::ExportDialog(Document& document, Player& player, Locks& locks, ExportQueue& queue, AskForFile askForFile,
    AskForChoice askForChoice, QWidget* parent)
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
    , m_range(new RangeRow(player, this))
    , m_data(new DataChoices(this))
    , m_flipbook(new FlipbookChoices(this))
    , m_preview(new PreviewPane(queue.shelf(), this))
    , m_pictures(new PictureChoices(this))
    , m_output(new OutputRows(document, locks, this))
    , m_summary(new SummaryRow(document, this))
    , m_progress(new ExportProgress(queue, this))
    , m_export(new QPushButton(tr("Export"), this))
    , m_cancel(new QPushButton(tr("Cancel"), this))
    , m_show(new QPushButton(tr("Show in folder"), this))
{
    setObjectName(QStringLiteral("exportDialog"));
    setWindowTitle(tr("Export"));
    nameWidget(*m_kind, QStringLiteral("export.kind"), tr("Type"));
    for (std::size_t each = 0; each < kExportKinds; ++each) {
        m_kind->addItem(kindName(static_cast<ExportKind>(each)));
    }
    nameWidget(*m_format, QStringLiteral("export.format"), tr("Format"));
    nameWidget(*m_path, QStringLiteral("export.path"), tr("File"));
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
    connect(m_range, &RangeRow::changed, this, &ExportDialog::followPlan);
    connect(m_summary, &SummaryRow::taken, this, [this](const ExportOffer& offer) {
        m_range->setFrames(offer.frames);
        m_flipbook->setGrid(offer.columns, offer.rows);
    });
    connect(m_data, &DataChoices::changed, this, &ExportDialog::followPlan);
    connect(m_flipbook, &FlipbookChoices::changed, this, &ExportDialog::followPlan);
    connect(m_pictures, &PictureChoices::changed, this, &ExportDialog::followPlan);
    connect(m_flipbook, &FlipbookChoices::cellsChosen, this, [this](int width, int height) {
        m_document.edit({{&knownParameter("output.width"), width}, {&knownParameter("output.height"), height}},
            tr("Size of cells"));
    });
    connect(m_flipbook, &FlipbookChoices::resized, this, &ExportDialog::fitScreen);
    connect(m_preview, &PreviewPane::resized, this, &ExportDialog::fitScreen);
    connect(&m_document, &Document::effectChanged, this, &ExportDialog::followEffect);
    connect(&m_document, &Document::layersChanged, this, &ExportDialog::followPlan); // files have their names
    connect(&m_document, &Document::loaded, this, [this] { m_pathIsSuggested = true; });
}

QHBoxLayout* ExportDialog::makePlace()
{
    auto* place = new QHBoxLayout;
    place->setSpacing(8);
    auto* choose = new QPushButton(tr("Choose…"), this);
    choose->setObjectName(QStringLiteral("export.choose"));
    place->addWidget(m_path, 1);
    place->addWidget(choose);
    connect(choose, &QPushButton::clicked, this, &ExportDialog::browse);
    return place;
}

void ExportDialog::buildForm()
{
    auto* form = new LabelledForm;
    form->add(tr("Type"), m_kind);
    form->add(tr("Format"), m_format);
    form->add(tr("File"), makePlace());
    form->add(tr("Frames"), m_range);
    form->addRow(m_flipbook);
    form->addRow(m_data);
    form->add(QString(), m_pictures);
    m_form = form;
    auto* content = new QWidget;
    auto* box = new QVBoxLayout(content);
    box->setContentsMargins({});
    box->addLayout(form);
    box->addWidget(m_output);
    box->addWidget(m_preview);
    box->addWidget(m_summary);
    box->addStretch();
    m_scroll->setObjectName(QStringLiteral("export.scroll"));
    m_scroll->setWidget(content);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    static_cast<QVBoxLayout*>(layout())->addWidget(m_scroll, 1);
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
    connect(&m_entry, &ExportSubmission::entered, this, &ExportDialog::followEntered);
    connect(&m_entry, &ExportSubmission::refused, m_progress, &ExportProgress::say);
    connect(&m_entry, &ExportSubmission::ended, this, &ExportDialog::followPlan);
    connect(&m_entry, &ExportSubmission::ended, this, &ExportDialog::entryEnded);
    connect(
        m_cancel, &QPushButton::clicked, this, [this] { m_queue.cancel(m_queue.rowOf(m_progress->followed()->id)); });
    connect(m_show, &QPushButton::clicked, this, [this] { showFolderOf(m_progress->followed()->job->plan); });
    connect(m_progress, &ExportProgress::changed, this, &ExportDialog::followProgress);
    connect(m_progress, &ExportProgress::fitRequested, this, [this] {
        m_pictures->setFitsCamera(true);
        begin();
    });
}

std::vector<ExportPlan> ExportDialog::choices() const
{
    std::vector<ExportPlan> all{choiceOf(kind())};
    for (std::size_t each = 0; each < kExportKinds; ++each) {
        all.push_back(choiceOf(static_cast<ExportKind>(each)));
    }
    all.erase(all.begin() + 1 + static_cast<std::ptrdiff_t>(kind()));
    return all;
}

void ExportDialog::take(std::span<const ExportPlan> choices)
{
    for (auto plan = choices.rbegin(); plan != choices.rend(); ++plan) { // what kinds share, the first has the say of
        m_formats[placeOfFormat(plan->kind)] = formatOf(*plan);
        m_flipbook->take(*plan);
        m_data->take(*plan);
        m_pictures->take(*plan);
    }
    if (!choices.empty()) {
        setKind(choices.front().kind);
        followKind(); // it may be the one that it was, in another format
    }
}

ExportPlan ExportDialog::choiceOf(ExportKind kind) const
{
    ExportPlan plan;
    plan.kind = kind;
    plan.frames = m_range->frames(kind);
    plan.source = toPath(m_document.filePath());
    m_data->applyTo(plan);
    setFormat(plan, m_formats[placeOfFormat(kind)]);
    if (kind == ExportKind::Flipbook) {
        m_flipbook->applyTo(plan);
    }
    m_pictures->applyTo(plan, m_document.preset());
    return plan;
}

ExportPlan ExportDialog::plan() const
{
    ExportPlan plan = choiceOf(kind());
    addPath(plan);
    return plan;
}

void ExportDialog::addPath(ExportPlan& plan) const
{
    if (!m_path->text().trimmed().isEmpty()) {
        plan.output = withEnding(toPath(m_path->text()), fileEnding(plan));
        m_pictures->applyTo(plan, m_document.preset()); // the manifest is named after it
    }
}

void ExportDialog::followKind()
{
    const QSignalBlocker blocker(m_format);
    m_format->clear();
    m_format->addItems(formatsOf(kind()));
    m_format->setCurrentIndex(m_formats[placeOfFormat(kind())]);
    m_pathIsSuggested = true;
    forgetDone();
    followPlan();
}

void ExportDialog::followFormat()
{
    m_formats[placeOfFormat(kind())] = m_format->currentIndex();
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
    if (!isVisible()) { // nobody sees it: showEvent() catches up
        return;
    }
    m_flipbook->follow(m_document.scene());
    m_pictures->setHasLayers(m_document.scene().layers.size() > 1);
    ExportPlan now = choiceOf(kind());
    showRowsOf(now);
    if (m_pathIsSuggested) {
        const QSignalBlocker blocker(m_path);
        m_path->setText(QDir::toNativeSeparators(suggestedPath(now, m_document)));
    }
    addPath(now);
    m_summary->follow(now, m_document.scene(), m_solo != nullptr && m_solo->isOn());
    if (kind() == ExportKind::Flipbook) {
        m_flipbook->followPlan(m_document.scene(), now);
        m_preview->follow(m_document.scene(), now);
    }
    m_export->setEnabled(!m_entry.isBusy() && isPossible(now, m_document.scene()));
}

void ExportDialog::showRowsOf(const ExportPlan& plan)
{
    m_output->follow(plan);
    m_range->follow(plan.kind);
    m_form->setRowVisible(m_range, RangeRow::isAskedOf(plan.kind));
    static_cast<QLabel*>(m_form->labelForField(m_range))
        ->setText(plan.kind == ExportKind::Picture ? tr("Frame") : tr("Frames"));
    m_flipbook->setVisible(plan.kind == ExportKind::Flipbook);
    m_preview->setVisible(plan.kind == ExportKind::Flipbook);
    m_data->follow(plan);
    m_pictures->follow(plan);
    m_form->setRowVisible(m_pictures, isPicture(plan.kind));
}

bool ExportDialog::forgetDone()
{
    const QueuedExport* last = m_progress->followed();
    const bool isDone = last == nullptr || !last->isActive();
    if (isDone) {
        m_progress->follow(0);
    }
    return isDone;
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

void ExportDialog::followEntered(quint64 id, const ExportPlan& plan, std::optional<ConflictPolicy> answered)
{
    if (answered == ConflictPolicy::KeepBoth) {
        setFile(fromPath(plan.output));
    }
    m_progress->follow(id);
    emit added(plan);
    emit chosen();
}

void ExportDialog::browse()
{
    setFile(m_askForFile(this,
        {.purpose = FileQuestion::Purpose::Save,
            .title = tr("Export to"),
            .start = m_path->text(),
            .mayReplace = true}));
}

void ExportDialog::setFrames(const FrameRange& frames)
{
    m_range->setFrames(frames);
}

void ExportDialog::setFile(const QString& path)
{
    if (!path.isEmpty()) {
        m_pathIsSuggested = false;
        m_path->setText(QDir::toNativeSeparators(path));
        takePath(path);
    }
}

void ExportDialog::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    if (forgetDone()) {
        m_range->takePlayed();
    }
    followPlan();
    measureKinds();
    fitScreen();
    emit shownChanged(true);
}

void ExportDialog::measureKinds()
{
    m_largest = {};
    const ExportPlan shown = plan();
    for (std::size_t each = 0; each < kExportKinds; ++each) {
        ExportPlan other = shown;
        other.kind = static_cast<ExportKind>(each);
        showRowsOf(other);
        m_largest = m_largest.expandedTo(contentSizeOf(*m_scroll));
    }
    showRowsOf(shown);
}

void ExportDialog::fitScreen()
{
    constexpr QSize kMargin(32 + 16, 48); // of the layout with a scroll bar; of the window
    const QSize content = contentSizeOf(*m_scroll).expandedTo(m_largest); // from kind to kind the buttons stay
    const int around = sizeHint().height() - m_scroll->sizeHint().height();
    resize(std::max(width(), content.width() + kMargin.width()),
        std::min(around + content.height(), screen()->availableGeometry().height() - kMargin.height()));
}

void ExportDialog::hideEvent(QHideEvent* event)
{
    QDialog::hideEvent(event);
    emit chosen();
    emit shownChanged(false);
}

} // namespace fumage::ui
