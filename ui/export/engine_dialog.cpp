#include "ui/export/engine_dialog.h"

#include "ui/document/text.h"
#include "ui/export/export_progress.h"
#include "ui/export/export_summary.h"
#include "ui/export/labelled_form.h"
#include "ui/export/mock_stage.h"
#include "ui/export/show_folder.h"

#include "core/effect/known_parameter.h"
#include "core/export/sheets/flipbook_files.h"
#include "core/export/sheets/sheet_reader.h"

#include <algorithm>

#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QShowEvent>
#include <QStackedWidget>

namespace fumage::ui {

namespace {

constexpr int kMargin = 16; ///< px
constexpr int kSpace = 12;
constexpr std::int64_t kMaxPixels = std::int64_t{4096} * 4096; ///< of a sheet that is played here: 256 MiB of colour

QPushButton* makeButton(const char* name, const QString& text, QWidget* parent)
{
    auto* button = new QPushButton(text, parent);
    button->setObjectName(QLatin1String(name));
    button->setAutoDefault(false);
    return button;
}

QString buttonName(Engine engine)
{
    return QStringLiteral("engine.") + toQString(nameOf(engine));
}

} // namespace

EngineDialog::EngineDialog(
    Document& document, ExportQueue& queue, AskForFile askForFile, AskForChoice askForChoice, QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_queue(queue)
    , m_askForFile(std::move(askForFile))
    , m_entry(queue, std::move(askForChoice), this)
    , m_pages(new QStackedWidget(this))
    , m_folder(new QLineEdit(this))
    , m_edge(new QComboBox(this))
    , m_title(new QLabel(this))
    , m_steps(new QLabel(this))
    , m_stage(new MockStage(this))
    , m_progress(new ExportProgress(queue, this))
    , m_back(makeButton("engine.back", tr("Another engine"), this))
    , m_cancel(makeButton("engine.cancel", tr("Cancel"), this))
    , m_show(makeButton("engine.show", tr("Show in folder"), this))
    , m_copy(makeButton("engine.copy", tr("Copy the path"), this))
{
    setObjectName(QStringLiteral("engineDialog"));
    setWindowTitle(tr("Into my engine"));
    m_pages->addWidget(makeChoicePage());
    m_pages->addWidget(makeResultPage());
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    layout->setSpacing(kSpace);
    layout->addWidget(m_pages, 1);
    layout->addWidget(m_progress);
    layout->addLayout(makeButtons());
    connectParts();
    take({});
    showChoice();
}

// --- parts ---

QWidget* EngineDialog::makeChoicePage()
{
    auto* page = new QWidget(this);
    auto* intro = new QLabel(
        tr("Choose an engine: a sheet with all that it needs is written, with the settings that suit it."), page);
    intro->setWordWrap(true);
    nameWidget(*m_folder, QStringLiteral("engine.folder"), tr("Folder"));
    nameWidget(*m_edge, QStringLiteral("engine.edge"), tr("Size of the sheet"));
    for (const int edge : kSheetEdges) {
        m_edge->addItem(tr("%1 pixels at most").arg(edge));
    }
    m_edge->setToolTip(tr("The longer side of the sheet. Cells of the document that are larger are made smaller"));
    QPushButton* choose = makeButton("engine.choose", tr("Choose…"), page);
    connect(choose, &QPushButton::clicked, this, &EngineDialog::browse);
    auto* place = new QHBoxLayout;
    place->addWidget(m_folder, 1);
    place->addWidget(choose);
    auto* form = new LabelledForm;
    form->add(tr("Folder"), place);
    form->add(tr("Sheet"), m_edge);
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins({});
    layout->setSpacing(kSpace);
    layout->addWidget(intro);
    layout->addLayout(makeEngines());
    layout->addLayout(form);
    layout->addStretch();
    return page;
}

QHBoxLayout* EngineDialog::makeEngines()
{
    auto* row = new QHBoxLayout;
    constexpr int kTall = 56; // px: the largest there is, as it is what one comes for
    for (const Engine engine : kOfferedEngines) {
        auto* button = new QPushButton(engineTitle(engine), this);
        nameWidget(*button, buttonName(engine), tr("Export for %1").arg(engineTitle(engine)));
        button->setMinimumHeight(kTall);
        row->addWidget(button, 1);
        connect(button, &QPushButton::clicked, this, [this, engine] { begin(engine); });
    }
    return row;
}

QWidget* EngineDialog::makeResultPage()
{
    auto* page = new QWidget(this);
    m_stage->setObjectName(QStringLiteral("engine.stage"));
    m_title->setObjectName(QStringLiteral("engine.title"));
    m_title->setProperty("role", QStringLiteral("title"));
    m_title->setTextFormat(Qt::PlainText);
    m_title->setWordWrap(true);
    m_steps->setObjectName(QStringLiteral("engine.steps"));
    m_steps->setTextFormat(Qt::PlainText);
    m_steps->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_steps->setWordWrap(true);
    constexpr int kReadable = 280; // px
    m_steps->setMinimumWidth(kReadable);
    auto* sky = new QComboBox(page);
    nameWidget(*sky, QStringLiteral("engine.sky"), tr("Sky"));
    sky->addItems({tr("Day"), tr("Evening"), tr("Night")});
    connect(sky, &QComboBox::currentIndexChanged, m_stage,
        [this](int index) { m_stage->setSky(static_cast<MockStage::Sky>(index)); });
    auto* files = new QHBoxLayout;
    files->addWidget(m_show);
    files->addWidget(m_copy);
    files->addStretch();
    auto* side = new QVBoxLayout;
    side->setSpacing(kSpace);
    side->addWidget(m_title);
    side->addWidget(m_steps);
    side->addLayout(files);
    side->addStretch();
    side->addWidget(sky, 0, Qt::AlignLeft);
    auto* layout = new QHBoxLayout(page);
    layout->setContentsMargins({});
    layout->setSpacing(kMargin);
    layout->addWidget(m_stage, 1);
    layout->addLayout(side);
    return page;
}

QHBoxLayout* EngineDialog::makeButtons()
{
    QPushButton* options = makeButton("engine.options", tr("More options…"), this);
    QPushButton* close = makeButton("engine.close", tr("Close"), this);
    connect(options, &QPushButton::clicked, this, [this] { emit optionsRequested(prepare(m_engine)); });
    connect(close, &QPushButton::clicked, this, &QWidget::close);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_back);
    buttons->addWidget(options);
    buttons->addStretch();
    buttons->addWidget(m_cancel);
    buttons->addWidget(close);
    return buttons;
}

void EngineDialog::connectParts()
{
    connect(&m_entry, &ExportSubmission::entered, this, [this](quint64 id, const ExportPlan& plan) {
        m_plan = plan;
        m_isRead = false;
        m_progress->follow(id);
        showResult();
        emit added(plan);
        emit chosen();
    });
    connect(&m_entry, &ExportSubmission::refused, m_progress, &ExportProgress::say);
    connect(&m_entry, &ExportSubmission::ended, this, [this] {
        m_pages->widget(0)->setEnabled(true);
        emit entryEnded();
    });
    connect(m_progress, &ExportProgress::changed, this, &EngineDialog::followProgress);
    connect(m_back, &QPushButton::clicked, this, &EngineDialog::showChoice);
    connect(
        m_cancel, &QPushButton::clicked, this, [this] { m_queue.cancel(m_queue.rowOf(m_progress->followed()->id)); });
    connect(m_show, &QPushButton::clicked, this, [this] { showFolderOf(*m_plan); });
    connect(m_copy, &QPushButton::clicked, this,
        [this] { QGuiApplication::clipboard()->setText(QDir::toNativeSeparators(fromPath(m_plan->output))); });
}

// --- what is chosen ---

QString EngineDialog::folder() const
{
    const QString typed = QDir::fromNativeSeparators(m_folder->text().trimmed());
    return QDir::isAbsolutePath(typed) ? QDir::cleanPath(typed) : usualEngineFolder();
}

EngineChoice EngineDialog::choice() const
{
    return {m_engine, kSheetEdges[static_cast<std::size_t>(m_edge->currentIndex())], folder()};
}

void EngineDialog::take(const EngineChoice& choice)
{
    m_engine = choice.engine;
    m_folder->setText(QDir::toNativeSeparators(choice.folder.isEmpty() ? usualEngineFolder() : choice.folder));
    m_edge->setCurrentIndex(
        static_cast<int>(std::ranges::find(kSheetEdges, choice.edge) - kSheetEdges.begin()) % m_edge->count());
}

void EngineDialog::browse()
{
    const QString chosen = m_askForFile(
        this, {.purpose = FileQuestion::Purpose::Folder, .title = tr("Folder for the engine"), .start = folder()});
    if (!chosen.isEmpty()) {
        m_folder->setText(QDir::toNativeSeparators(chosen));
    }
}

// --- what comes of it ---

ExportPlan EngineDialog::prepare(Engine engine)
{
    const Output& output = m_document.scene().output;
    ExportPlan plan = recommendedPlan(engine, m_document, folder());
    const auto [width, height] = cellsWithin(choice().edge, plan, output);
    if (width == output.width && height == output.height) {
        return plan;
    }
    m_document.edit(
        {{&knownParameter("output.width"), width}, {&knownParameter("output.height"), height}}, tr("Size of cells"));
    return recommendedPlan(engine, m_document, folder());
}

void EngineDialog::begin(Engine engine)
{
    m_engine = engine;
    const ExportPlan plan = prepare(engine);
    if (!isPossible(plan, m_document.scene())) {
        m_progress->say(summaryOf(plan, m_document.scene()));
        return;
    }
    m_pages->widget(0)->setEnabled(false); // until it is known what becomes of files that are there
    m_entry.enter({m_document.displayName().toStdString(), m_document.preset(), plan});
}

void EngineDialog::showChoice()
{
    m_reading.forget();
    m_pages->setCurrentIndex(0);
    m_back->hide();
    m_stage->play(nullptr);
    auto* button = findChild<QPushButton*>(buttonName(m_engine));
    button->setDefault(true);
    button->setFocus();
    const QueuedExport* last = m_progress->followed();
    if (last == nullptr || !last->isActive()) {
        m_progress->follow(0);
    }
    followProgress();
}

void EngineDialog::showResult()
{
    m_reading.forget();
    const QString engine = engineTitle(m_plan->flipbook.engine);
    m_title->setText(tr("%1 for %2").arg(fromPath(m_plan->output.filename()), engine));
    QStringList lines;
    for (const QString& step : engineSteps(*m_plan)) {
        lines << QStringLiteral("%1. %2").arg(lines.size() + 1).arg(step);
    }
    m_steps->setText(lines.join(QStringLiteral("\n\n")));
    m_stage->say(tr("The sheet is being rendered…"));
    m_pages->setCurrentIndex(1);
    m_back->show();
    followProgress();
}

void EngineDialog::followProgress()
{
    const QueuedExport* last = m_progress->followed();
    // Its files are there, whether the queue knows of it still or not.
    const bool isDone = last != nullptr ? last->state == ExportState::Done : m_isRead;
    m_cancel->setVisible(last != nullptr && last->isActive());
    m_show->setEnabled(isDone);
    m_copy->setEnabled(isDone);
    if (isDone && !m_isRead && m_pages->currentIndex() == 1) {
        m_isRead = true;
        readBack();
    } else if (last != nullptr && !isDone && !last->isActive()) {
        m_stage->say({});
    }
}

void EngineDialog::readBack()
{
    m_stage->say(tr("The sheet is being read…"));
    m_reading.ask(
        [this, file = descriptionOf(m_plan->output)](const AsyncRequest::Report& report, const std::stop_token&) {
            const Result<std::shared_ptr<const SheetPreview>> sheet = readFlipbook(file, kMaxPixels);
            if (sheet) {
                report([this, read = sheet.value()] { m_stage->play(read); });
            } else {
                report([this, why = translated(sheet.error())] { m_stage->say(why); });
            }
        },
        [this](const Error& why) { m_stage->say(translated(why)); });
}

void EngineDialog::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    const QueuedExport* last = m_progress->followed();
    if (!event->spontaneous() && (last == nullptr || !last->isActive())) {
        showChoice(); // the smoke is another by now
    }
}

} // namespace fumage::ui
