#pragma once

#include "ui/document/document.h"
#include "ui/document/locks.h"
#include "ui/document/solo.h"
#include "ui/export/export_submission.h"
#include "ui/widgets/choice_question.h"
#include "ui/widgets/file_question.h"
#include "ui/timeline/player.h"

#include <memory>

class QAction;
class QWidget;

namespace fumage::ui {

class ActionSet;
class EngineDialog;
class ExportDialog;
class Settings;

/// The exports of one window: the dialog that adds them to the program's queue, and the news of the queue for those who
/// look at neither.
class ExportController : public QObject {
    Q_OBJECT

public:
    /// @param askForFile for the names of files
    /// @param window parent of the dialog
    ExportController(ExportQueue& queue, Document& document, const Solo& solo, Player& player, Locks& locks,
        const ActionSet& actions, const AskForFile& askForFile, const AskForChoice& askForChoice, Settings& settings,
        QWidget* window);
    ~ExportController() override;

    ExportDialog& openDialog();
    /// The short way into an engine.
    EngineDialog& openEngine();
    /// What was exported last from this window, with the smoke as it is now; opens the dialog where nothing has been.
    void exportLastAgain();
    /// The same of any plan; asks once what becomes of files that are there.
    void exportAgain(const ExportPlan& plan);
    /// Whether an export is on its way into the queue: its files are looked for, which may take its time on a disk that
    /// is far away.
    [[nodiscard]] bool isBusy() const;

signals:
    /// @param forMs how long it is of interest; 0: until the next news
    void news(const QString& message, int forMs);
    /// To the queue.
    void added();
    /// None is on its way into the queue any more.
    void rested();

private:
    void makeDialog();
    void makeEngine();
    /// The dialog with the flipbook of a plan, and all else as it was.
    void showOptions(const ExportPlan& plan);
    void rememberChoices();
    void rest();
    void report(quint64 id);

    ExportQueue& m_queue;
    Document& m_document;
    const Solo& m_solo;
    Player& m_player;
    Locks& m_locks;
    const ActionSet& m_actions;
    QAction& m_frame; ///< the exported frame in the picture, shown while the dialog is open
    const AskForFile& m_askForFile;
    const AskForChoice& m_askForChoice;
    Settings& m_settings; ///< remember what was chosen in the dialog
    QWidget* m_window;
    std::optional<ExportPlan> m_last; ///< that was added to the queue
    std::optional<ConflictPolicy> m_againOnConflict; ///< what was answered last time, until the dialog is seen
    ExportSubmission m_again;
    std::unique_ptr<ExportDialog> m_dialog; ///< null until it is asked for
    std::unique_ptr<EngineDialog> m_engine; ///< likewise
};

} // namespace fumage::ui
