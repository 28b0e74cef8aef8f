#include "ui/widgets/message_box.h"

#include <QLabel>

namespace fumage::ui {

MessageBox::MessageBox(
    const QString& name, Icon icon, const QString& title, const QString& text, StandardButtons buttons, QWidget* parent)
    : QMessageBox(parent)
{
    setObjectName(name);
    setIcon(icon);
    setWindowTitle(title);
    setTextFormat(Qt::PlainText);
    setText(text);
    setStandardButtons(buttons);
}

void MessageBox::explain(const QString& text)
{
    const Qt::TextFormat format = textFormat();
    setInformativeText(QStringLiteral(" ")); // makes the label, which has a format of its own
    for (QLabel* label : findChildren<QLabel*>()) {
        label->setTextFormat(Qt::PlainText);
    }
    setTextFormat(format);
    setInformativeText(text);
}

void MessageBox::warn(QWidget* parent, const QString& title, const QString& text)
{
    MessageBox(QStringLiteral("warningBox"), Warning, title, text, Ok, parent).exec();
}

bool MessageBox::ask(QWidget* parent, const QString& title, const QString& text)
{
    MessageBox box(QStringLiteral("questionBox"), Question, title, text, Yes | No, parent);
    box.setDefaultButton(No); // what cannot be undone is not done by a Return that comes too early
    return box.exec() == Yes;
}

} // namespace fumage::ui
