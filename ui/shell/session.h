#pragma once

#include "ui/document/recovery.h"
#include "ui/shell/app_services.h"

#include <QList>
#include <QPointer>

#include <memory>

class QEventLoopLocker;

namespace fumage::ui {

class MainWindow;

/// The program: its windows, and what they share.
class Session : public AppServices {
    Q_OBJECT

public:
    /// @param askForFile,askForChoice tests answer without a dialog
    explicit Session(
        AskForFile askForFile = askInDialog, AskForChoice askForChoice = askInBox, QObject* parent = nullptr);
    ~Session() override;

    /// Opens a window; it deletes itself when it is closed.
    MainWindow* openWindow();
    /// Opens what a crash has left and the files that were named; if there are none, an empty window with the start
    /// dialog.
    void start(const QStringList& files);
    void addWindow() override { openWindow(); }
    void closeAll() override;
    [[nodiscard]] bool mayClose(QWidget& window) override;
    [[nodiscard]] bool isEnding() const override { return m_isEnding; }

    /// The desktop's session may end, or not: unsaved work is on the disk in either case.
    void keepWork();
    /// The program is about to be ended by others: unsaved work stays on the disk for the next one.
    void leaveWork();
    /// The program ends: windows that are still open were not closed by their user. At the end of a Windows session Qt
    /// tells them to close only after this.
    void end();

private:
    void recover(std::vector<Recovery::Work>& works);
    /// Shows those of programs that are gone, and starts none of them.
    void offerExports();
    void connectExports();
    [[nodiscard]] bool isLast(const QWidget& window) const;

    std::shared_ptr<QEventLoopLocker> m_untilExported; ///< keeps the program alive without a window; null: nothing does
    QList<QPointer<MainWindow>> m_windows;
    bool m_isEnding = false;
};

} // namespace fumage::ui
