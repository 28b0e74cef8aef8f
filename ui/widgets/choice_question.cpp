#include "ui/widgets/choice_question.h"

#include "ui/widgets/message_box.h"
#include "ui/widgets/plain_text.h"

#include <QPushButton>

namespace fumage::ui {

int askInBox(QWidget* parent, const ChoiceQuestion& question)
{
    MessageBox box(question.name, MessageBox::Question, question.title, question.text, MessageBox::NoButton, parent);
    QList<QAbstractButton*> buttons;
    for (const QString& answer : question.answers) {
        // All of one role: else the desktop would put them into an order of its own.
        // An answer may name a file: an & in it is none of a key.
        buttons += box.addButton(plainMenuText(answer), MessageBox::ActionRole);
        // The theme's least width would count as enough, and the box is as narrow as can be.
        buttons.constLast()->ensurePolished();
        buttons.constLast()->setMinimumWidth(buttons.constLast()->sizeHint().width());
    }
    box.setDefaultButton(qobject_cast<QPushButton*>(buttons.constFirst()));
    box.setEscapeButton(buttons.constLast());
    box.exec();
    return static_cast<int>(buttons.indexOf(box.clickedButton()));
}

} // namespace fumage::ui
