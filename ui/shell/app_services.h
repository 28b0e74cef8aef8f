#pragma once

#include "ui/concurrency/async_request.h"
#include "ui/export/export_queue.h"
#include "ui/shell/settings.h"
#include "ui/viewport/gl_support.h"
#include "ui/widgets/choice_question.h"
#include "ui/widgets/file_question.h"

#include "core/base/parallel.h"

#include <QObject>
#include <QTimer>

#include <optional>

namespace fumage::ui {

/// What all windows of the program share: settings, exports, what OpenGL can do, and what a window asks of the program.
class AppServices : public QObject {
    Q_OBJECT

public:
    [[nodiscard]] Settings& settings() { return m_settings; }
    [[nodiscard]] GlSupport glSupport() const { return m_glSupport; }
    [[nodiscard]] const AskForFile& askForFile() const { return m_askForFile; }
    [[nodiscard]] const AskForChoice& askForChoice() const { return m_askForChoice; }

    [[nodiscard]] ExportQueue& exports() { return m_exports; }
    /// Of the air of what is shown and exported.
    [[nodiscard]] const std::shared_ptr<AirCache>& shelf() const { return m_exports.shelf(); }

    void applyTheme(Theme theme);
    /// How many threads compute where the settings set no limit.
    [[nodiscard]] int allThreads() const { return m_allThreads; }
    /// Memory that is no longer needed goes back to the system in a moment.
    void giveBackMemorySoon();

    /// Opens one more window.
    virtual void addWindow() = 0;
    /// Closes all windows, until one of them stays.
    virtual void closeAll() = 0;
    /// Asks what becomes of exports that are not done, where a window is the last; they may go on without one, and the
    /// program runs until then.
    /// @return whether the window closes
    [[nodiscard]] virtual bool mayClose(QWidget& window) = 0;
    /// Whether the program ends whatever windows say: they close without a question, and unsaved work stays on the
    /// disk.
    [[nodiscard]] virtual bool isEnding() const = 0;

protected:
    /// @param askForFile,askForChoice tests answer without a dialog
    AppServices(AskForFile askForFile, AskForChoice askForChoice, QObject* parent);

private:
    void limitThreads(int threads);
    /// Thumbnails on the disk come down to their size, on another thread.
    void pruneCache(int megabytes);

    Settings m_settings;
    const int m_allThreads;
    std::optional<ThreadLimit> m_threads; ///< none: as many as there are
    const AskForFile m_askForFile;
    const AskForChoice m_askForChoice;
    const bool m_desktopIsDark; ///< as the program found it
    GlSupport m_glSupport;
    ExportQueue m_exports;
    QTimer m_thrift;
    AsyncRequest m_pruning;
    AsyncRequest m_giving; ///< last: its thread ends first
};

} // namespace fumage::ui
