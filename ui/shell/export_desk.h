#pragma once

#include "ui/document/document.h"
#include "ui/document/locks.h"
#include "ui/export/export_clash.h"
#include "ui/export/export_job.h"
#include "ui/face/choice_question.h"
#include "ui/face/file_question.h"
#include "ui/timeline/player.h"

#include <memory>

class QAction;
class QWidget;

namespace fumage::ui {

class ActionSet;
class ExportDialog;

/// The exports of one window: the job, the dialog that begins it, and the news of it for those who have closed the dialog.
class ExportDesk : public QObject {
    Q_OBJECT

public:
    /// @param askForFile for the names of files
    /// @param window parent of the dialog
    ExportDesk(Document& document, Player& player, Locks& locks, const ActionSet& actions, const AskForFile& askForFile, const AskForChoice& askForChoice, QWidget* window);
    ~ExportDesk() override;

    [[nodiscard]] ExportJob& job() { return *m_job; }
    ExportDialog& openDialog();
    /// The same again; asks where nothing has been exported yet, and once what becomes of files that are there.
    void exportAgain();

    /// What becomes of an export that runs when its window closes.
    enum class Leaving {
        Stop, ///< also where none runs
        Finish, ///< whoever asked takes the job
        Stay, ///< the window does not close
    };
    [[nodiscard]] Leaving askBeforeLeaving() const;
    /// The job that runs; the desk goes on with another.
    [[nodiscard]] std::unique_ptr<ExportJob> takeJob();

signals:
    /// @param forMs how long it is of interest; 0: until the next news
    void news(const QString& message, int forMs);

private:
    void connectNews();

    Document& m_document;
    Player& m_player;
    Locks& m_locks;
    QAction& m_frame; ///< the exported frame in the picture, shown while the dialog is open
    const AskForFile& m_askForFile;
    const AskForChoice& m_askForChoice;
    QWidget* m_window;
    std::unique_ptr<ExportJob> m_job;
    std::optional<OnClash> m_againOnClash; ///< what was answered last time, until the dialog is seen
    std::unique_ptr<ExportDialog> m_dialog; ///< null until it is asked for
};

} // namespace fumage::ui
