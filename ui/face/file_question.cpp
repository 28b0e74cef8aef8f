#include "ui/face/file_question.h"

#include <QFileDialog>

namespace fumage::ui {

QString askInDialog(QWidget* parent, const FileQuestion& question)
{
    // Takes folder and name out of the start.
    QFileDialog dialog(parent, question.title, question.start, question.filter);
    dialog.setObjectName(QStringLiteral("fileDialog"));
    const bool saves = question.purpose == FileQuestion::Purpose::Save;
    dialog.setAcceptMode(saves ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    dialog.setFileMode(saves ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
    dialog.setOption(QFileDialog::DontConfirmOverwrite, question.mayReplace);
    dialog.setDefaultSuffix(question.ending);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().constFirst() : QString();
}

} // namespace fumage::ui
