#include "ui/shell/export_controller.h"

#include "ui/document/text.h"
#include "ui/export/engine_dialog.h"
#include "ui/export/export_dialog.h"
#include "ui/widgets/window_keeper.h"
#include "ui/shell/action_table.h"
#include "ui/shell/settings.h"

#include "core/export/jobs/job_file.h"

#include <algorithm>
#include <array>

#include <QDir>

namespace fumage::ui {

namespace {

const QString kChoices = QStringLiteral("exports/choices");
/// What a dialog that is a window of its own must do by the same keys.
constexpr std::array kKeysOfWindow{"file.quit", "file.save", "edit.undo", "edit.redo"};
const QString kEngine = QStringLiteral("exports/engine");

} // namespace

ExportController::ExportController(ExportQueue& queue, Document& document, const Solo& solo, Player& player,
    Locks& locks, const ActionSet& actions, const AskForFile& askForFile, const AskForChoice& askForChoice,
    Settings& settings, QWidget* window)
    : m_queue(queue)
    , m_document(document)
    , m_solo(solo)
    , m_player(player)
    , m_locks(locks)
    , m_actions(actions)
    , m_frame(actions.get("view.frame"))
    , m_askForFile(askForFile)
    , m_askForChoice(askForChoice)
    , m_settings(settings)
    , m_window(window)
    , m_again(queue, askForChoice, window)
{
    actions.on("file.export", this, [this] { openDialog(); });
    actions.on("file.engine", this, [this] { openEngine(); });
    actions.on("file.exportAgain", this, &ExportController::exportLastAgain);
    connect(&queue, &ExportQueue::changed, this, &ExportController::report);
    connect(&m_again, &ExportSubmission::refused, this, [this](const QString& message) { emit news(message, 0); });
    connect(&m_again, &ExportSubmission::entered, this,
        [this](quint64, const ExportPlan& plan, std::optional<ConflictPolicy> answered) {
            m_againOnConflict = answered;
            m_last = plan;
            emit added();
        });
    connect(&m_again, &ExportSubmission::ended, this, &ExportController::rest);
    connect(&queue, &ExportQueue::notKept, this, [this](const QString& message) {
        emit news(tr("The queue of exports cannot be kept safe: %1").arg(message), 0);
    });
}

ExportController::~ExportController() = default;

void ExportController::makeDialog()
{
    m_dialog =
        std::make_unique<ExportDialog>(m_document, m_player, m_locks, m_queue, m_askForFile, m_askForChoice, m_window);
    std::vector<ExportPlan> choices;
    for (const QString& text : m_settings.list(kChoices, {})) {
        if (const std::optional<ExportPlan> plan = parsePlan(text.toStdString())) {
            choices.push_back(*plan);
        }
    }
    m_dialog->take(choices);
    m_dialog->setSolo(m_solo);
    // A window of its own has the keys of its actions alone.
    for (const char* id : kKeysOfWindow) {
        m_dialog->addAction(&m_actions.get(id));
    }
    connect(m_dialog.get(), &ExportDialog::shownChanged, this, [this] { m_againOnConflict.reset(); });
    connect(m_dialog.get(), &ExportDialog::shownChanged, &m_frame, &QAction::setChecked);
    connect(m_dialog.get(), &ExportDialog::entryEnded, this, &ExportController::rest);
    connect(m_dialog.get(), &ExportDialog::chosen, this, &ExportController::rememberChoices);
    connect(m_dialog.get(), &ExportDialog::added, this, [this](const ExportPlan& plan) {
        m_last = plan;
        emit added();
    });
}

void ExportController::rememberChoices()
{
    QStringList texts;
    for (const ExportPlan& plan : m_dialog->choices()) {
        texts << toQString(formatPlan(plan));
    }
    m_settings.setList(kChoices, texts);
}

ExportDialog& ExportController::openDialog()
{
    if (m_dialog == nullptr) {
        makeDialog();
    }
    const bool wasOpen = m_dialog->isVisible();
    m_dialog->show();
    if (!wasOpen) {
        placeBeside(*m_window, *m_dialog);
    }
    m_dialog->raise();
    return *m_dialog;
}

void ExportController::makeEngine()
{
    m_engine = std::make_unique<EngineDialog>(m_document, m_queue, m_askForFile, m_askForChoice, m_window);
    m_engine->take(engineChoiceOf(m_settings.list(kEngine, {})));
    for (const char* id : kKeysOfWindow) {
        m_engine->addAction(&m_actions.get(id));
    }
    connect(m_engine.get(), &EngineDialog::entryEnded, this, &ExportController::rest);
    connect(m_engine.get(), &EngineDialog::optionsRequested, this, &ExportController::showOptions);
    connect(m_engine.get(), &EngineDialog::chosen, this,
        [this] { m_settings.setList(kEngine, textsOf(m_engine->choice())); });
    connect(m_engine.get(), &EngineDialog::added, this, [this](const ExportPlan& plan) {
        m_againOnConflict.reset();
        m_last = plan;
        emit added();
    });
}

EngineDialog& ExportController::openEngine()
{
    if (m_engine == nullptr) {
        makeEngine();
    }
    m_engine->show();
    m_engine->raise();
    m_engine->activateWindow();
    return *m_engine;
}

void ExportController::showOptions(const ExportPlan& plan)
{
    ExportDialog& dialog = openDialog();
    std::vector<ExportPlan> all = dialog.choices();
    const auto isFlipbook = [](const ExportPlan& each) { return each.kind == ExportKind::Flipbook; };
    ExportPlan first = *std::ranges::find_if(all, isFlipbook); // what kinds share stays as it is chosen there
    first.format = plan.format;
    first.passes = plan.passes;
    first.style = plan.style;
    first.layers = plan.layers;
    first.flipbook = plan.flipbook;
    first.fitCamera = plan.fitCamera;
    first.outlierPercent = plan.outlierPercent;
    first.project = plan.project;
    all.insert(all.begin(), first);
    dialog.take(all);
    dialog.setFrames(plan.frames);
    dialog.setFile(fromPath(plan.output));
    m_engine->close();
}

void ExportController::exportLastAgain()
{
    if (m_last) {
        exportAgain(ExportPlan(*m_last)); // a copy: it becomes the last
    } else {
        openDialog();
    }
}

void ExportController::exportAgain(const ExportPlan& plan)
{
    ExportJob job{m_document.displayName().toStdString(), m_document.preset(), plan};
    job.plan.source = toPath(m_document.filePath());
    m_again.enter(std::move(job), m_againOnConflict);
}

bool ExportController::isBusy() const
{
    return m_again.isBusy() || (m_dialog != nullptr && m_dialog->isEntering())
        || (m_engine != nullptr && m_engine->isEntering());
}

void ExportController::rest()
{
    if (!isBusy()) {
        emit rested();
    }
}

void ExportController::report(quint64 id)
{
    constexpr int kShownMs = 8000;
    const QueuedExport& one = *m_queue.find(id);
    const QString name = toQString(one.job->name);
    switch (one.state) {
    case ExportState::Running: emit news(tr("Exporting “%1”: %2").arg(name, one.told), 0); break;
    case ExportState::Done:
        emit news(
            tr("Exported %1").arg(QDir::toNativeSeparators(fromPath(firstFile(one.job->preset.scene, one.job->plan)))),
            kShownMs);
        break;
    case ExportState::Cancelled: emit news(tr("Export cancelled"), kShownMs); break;
    case ExportState::Failed: emit news(tr("Export failed: %1").arg(one.told), 0); break;
    case ExportState::Held:
    case ExportState::Starting:
    case ExportState::Waiting: break;
    }
}

} // namespace fumage::ui
