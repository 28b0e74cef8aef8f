#pragma once

#include "ui/document/recovery.h"
#include "ui/face/file_question.h"
#include "ui/shell/settings.h"
#include "ui/viewport/gl_support.h"

#include <QList>
#include <QObject>
#include <QPointer>

namespace fumage::ui {

class MainWindow;

/// What all windows of the program share: settings, what OpenGL can do, and who else is open.
class Session : public QObject {
    Q_OBJECT

public:
    /// @param ask for the names of files; tests answer without a dialog
    explicit Session(AskForFile ask = askInDialog, QObject* parent = nullptr);
    ~Session() override;

    [[nodiscard]] Settings& settings() { return m_settings; }
    [[nodiscard]] GlSupport glSupport() const { return m_glSupport; }
    [[nodiscard]] const AskForFile& askForFile() const { return m_askForFile; }

    /// Opens a window; it deletes itself when it is closed.
    MainWindow* openWindow();
    /// Opens what a crash has left and the files that were named; if there are none, an empty window with the start dialog.
    void start(const QStringList& files);
    void closeAll();

    void applyTheme(Theme theme);

private:
    void recover(std::vector<Recovery::Work>& works);

    Settings m_settings;
    const AskForFile m_askForFile;
    const bool m_desktopIsDark; ///< as the program found it
    GlSupport m_glSupport;
    QList<QPointer<MainWindow>> m_windows;
};

} // namespace fumage::ui
