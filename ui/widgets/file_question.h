#pragma once

#include <QString>

#include <functional>

class QWidget;

namespace fumage::ui {

/// What is asked where the name of a file is needed.
struct FileQuestion {
    enum class Purpose {
        Open, ///< a file that is there
        Save, ///< a file that is written; one that is there is asked about
        Folder, ///< that is there, or is made in the dialog
    };
    Purpose purpose = Purpose::Open;
    QString title;
    QString start; ///< the folder, or the file, that is offered
    QString filter; ///< "Presets (*.json);;All files (*)"; empty: all files
    bool mayReplace = false; ///< a file that is there is not asked about: whoever asks does it later
    QString ending{}; ///< that a saved file gets where its name has another or none, without the dot; empty: names stay
                      ///< as they are
};

/// Asks a person for the name of a file.
/// @return empty: none was chosen
using AskForFile = std::function<QString(QWidget* parent, const FileQuestion& question)>;

/// Asks in a dialog.
[[nodiscard]] QString askInDialog(QWidget* parent, const FileQuestion& question);

} // namespace fumage::ui
