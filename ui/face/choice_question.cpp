#include "ui/face/choice_question.h"

#include <QMessageBox>
#include <QPushButton>

namespace fumage::ui {

int askInBox(QWidget* parent, const ChoiceQuestion& question)
{
    QMessageBox box(parent);
    box.setObjectName(question.name);
    box.setIcon(QMessageBox::Question);
    box.setWindowTitle(question.title);
    box.setTextFormat(Qt::PlainText); // names of files may look like HTML
    box.setText(question.text);
    QList<QAbstractButton*> buttons;
    for (const QString& answer : question.answers) {
        // All of one role: else the desktop would put them into an order of its own.
        buttons += box.addButton(answer, QMessageBox::ActionRole);
    }
    box.setDefaultButton(qobject_cast<QPushButton*>(buttons.constFirst()));
    box.setEscapeButton(buttons.constLast());
    box.exec();
    return static_cast<int>(buttons.indexOf(box.clickedButton()));
}

} // namespace fumage::ui
