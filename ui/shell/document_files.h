#pragma once

#include "ui/document/document.h"
#include "ui/widgets/choice_question.h"
#include "ui/widgets/file_question.h"
#include "ui/shell/settings.h"

#include "core/preset/library.h"

#include <QObject>

namespace fumage::ui {

/// Opening, saving and giving up the document of one window, with the questions and messages that belong to it.
class DocumentFiles : public QObject {
    Q_OBJECT

public:
    /// @param ask for the names of files
    /// @param askForChoice what becomes of a file that others have changed
    /// @param window parent of dialogs
    DocumentFiles(Document& document, Settings& settings, const AskForFile& ask, const AskForChoice& askForChoice,
        QWidget* window);

    /// Asks what shall become of unsaved changes. @return whether to go on
    [[nodiscard]] bool confirmDiscard();

    void newDocument();
    void open();
    /// @return whether the file is open now
    bool openFile(const QString& name);
    /// Shows a preset that has no file of its own.
    bool openPreset(const Preset& preset);
    /// Shows a preset of the library.
    void openEntry(const LibraryEntry& entry);
    /// Asks before it writes over what others have written to the file.
    bool save();
    bool saveAs();
    /// Takes over what others have written to the file.
    void reload();
    /// Writes a copy to the user's presets and goes on with it.
    void saveToLibrary();
    void revert();
    void copyPreset() const;
    void pastePreset();

signals:
    /// A file was written to the user's presets.
    void libraryChanged();
    /// A picture was opened as the preset that it carries, and shows this frame of it.
    void pictureOpened(int frame);

private:
    bool saveTo(const QString& path);
    bool saveOverChanges();
    [[nodiscard]] QString askForName() const; ///< of a preset of the library; empty: none
    [[nodiscard]] bool mayReplace(const QString& name) const;
    [[nodiscard]] QString suggestedPath() const;
    void report(const QString& title, const Error& error) const;
    void showWarnings(const QString& name, const std::vector<Message>& warnings) const;

    Document& m_document;
    Settings& m_settings;
    const AskForFile& m_ask;
    const AskForChoice& m_askForChoice;
    QWidget* m_window;
};

} // namespace fumage::ui
