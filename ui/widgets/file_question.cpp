#include "ui/widgets/file_question.h"

#include "ui/widgets/message_box.h"

#include <QFileDialog>
#include <QFileInfo>

namespace fumage::ui {

namespace {

/// The name with the ending that it lacks: Qt takes what follows any dot for one, and "smoke v1.2" has none.
QString completed(const QString& path, const FileQuestion& question)
{
    const QString ending = QLatin1Char('.') + question.ending;
    const bool isWhole = question.purpose != FileQuestion::Purpose::Save || question.ending.isEmpty()
        || path.endsWith(ending, Qt::CaseInsensitive);
    return isWhole ? path : path + ending;
}

bool mayReplace(const QString& path, QFileDialog& dialog)
{
    const QString text = MessageBox::tr("“%1” exists already. Replace it?").arg(QFileInfo(path).fileName());
    MessageBox box(QStringLiteral("replaceFileBox"), MessageBox::Warning, dialog.windowTitle(), text,
        MessageBox::Yes | MessageBox::No, &dialog);
    box.setDefaultButton(MessageBox::No);
    return box.exec() == MessageBox::Yes;
}

} // namespace

QString askInDialog(QWidget* parent, const FileQuestion& question)
{
    // Takes folder and name out of the start.
    QFileDialog dialog(parent, question.title, question.start, question.filter);
    dialog.setObjectName(QStringLiteral("fileDialog"));
    const bool saves = question.purpose == FileQuestion::Purpose::Save;
    dialog.setAcceptMode(saves ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    const bool isFolder = question.purpose == FileQuestion::Purpose::Folder;
    dialog.setFileMode(saves ? QFileDialog::AnyFile : isFolder ? QFileDialog::Directory : QFileDialog::ExistingFile);
    dialog.setOption(QFileDialog::ShowDirsOnly, isFolder);
    dialog.setOption(QFileDialog::DontConfirmOverwrite, question.mayReplace);
    dialog.setDefaultSuffix(question.ending);
    while (dialog.exec() == QDialog::Accepted) {
        const QString chosen = dialog.selectedFiles().constFirst();
        QString path = completed(chosen, question);
        // The dialog has asked about the name as it was typed.
        if (path == chosen || question.mayReplace || !QFileInfo::exists(path) || mayReplace(path, dialog)) {
            return path;
        }
    }
    return {};
}

} // namespace fumage::ui
