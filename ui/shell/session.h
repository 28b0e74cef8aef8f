#pragma once

#include "ui/document/recovery.h"
#include "ui/export/export_queue.h"
#include "ui/face/choice_question.h"
#include "ui/face/file_question.h"
#include "ui/shell/settings.h"
#include "ui/viewport/gl_support.h"
#include "ui/work/answer_job.h"

#include <QList>
#include <QObject>
#include <QPointer>
#include <QTimer>

#include <memory>

class QEventLoopLocker;

namespace fumage::ui {

class MainWindow;

/// What all windows of the program share: settings, exports, what OpenGL can do, and who else is open.
class Session : public QObject {
    Q_OBJECT

public:
    /// @param askForFile,askForChoice tests answer without a dialog
    explicit Session(AskForFile askForFile = askInDialog, AskForChoice askForChoice = askInBox, QObject* parent = nullptr);
    ~Session() override;

    [[nodiscard]] Settings& settings() { return m_settings; }
    [[nodiscard]] GlSupport glSupport() const { return m_glSupport; }
    [[nodiscard]] const AskForFile& askForFile() const { return m_askForFile; }
    [[nodiscard]] const AskForChoice& askForChoice() const { return m_askForChoice; }

    [[nodiscard]] ExportQueue& exports() { return m_exports; }

    /// Opens a window; it deletes itself when it is closed.
    MainWindow* openWindow();
    /// Opens what a crash has left and the files that were named; if there are none, an empty window with the start dialog.
    void start(const QStringList& files);
    void closeAll();
    /// Asks what becomes of exports that are not done, where a window is the last; they may go on without one, and the program runs until then.
    /// @return whether the window closes
    [[nodiscard]] bool mayClose(MainWindow& window);

    void applyTheme(Theme theme);

    /// Memory that is no longer needed goes back to the system in a moment.
    void giveBackMemorySoon();
    /// The program is about to be ended by others: unsaved work stays on the disk for the next one.
    void leaveWork();

private:
    void recover(std::vector<Recovery::Work>& works);
    /// Shows those of programs that are gone, and starts none of them.
    void offerExports();
    void connectExports();
    [[nodiscard]] bool isLast(const MainWindow& window) const;

    Settings m_settings;
    const AskForFile m_askForFile;
    const AskForChoice m_askForChoice;
    const bool m_desktopIsDark; ///< as the program found it
    GlSupport m_glSupport;
    ExportQueue m_exports;
    std::shared_ptr<QEventLoopLocker> m_untilExported; ///< keeps the program alive without a window; null: nothing does
    QList<QPointer<MainWindow>> m_windows;
    QTimer m_thrift;
    AnswerJob m_giving; ///< last: its thread ends first
};

} // namespace fumage::ui
