#include "ui/widgets/plain_text.h"

#include <QEvent>
#include <QFileDialog>
#include <QLabel>
#include <QTextDocument>

namespace fumage::ui {

namespace {

bool isInFileDialog(const QObject* object)
{
    while (object != nullptr && qobject_cast<const QFileDialog*>(object) == nullptr) {
        object = object->parent();
    }
    return object != nullptr;
}

/// The label of a tool tip tells HTML from text itself: what gets there has been through the functions above.
bool isToolTip(const QLabel& label)
{
    return label.windowType() == Qt::ToolTip;
}

} // namespace

QString plainToolTip(const QString& text)
{
    return Qt::mightBeRichText(text)
        ? QStringLiteral("<span style=\"white-space: pre-wrap\">%1</span>").arg(text.toHtmlEscaped())
        : text;
}

QString titledToolTip(const QString& title, const QString& text)
{
    return QStringLiteral("<b>%1</b><br>%2").arg(title.toHtmlEscaped(), text.toHtmlEscaped());
}

QString plainMenuText(const QString& text)
{
    QString plain = text;
    return plain.replace(QLatin1Char('\t'), QLatin1Char(' ')).replace(QLatin1Char('&'), QStringLiteral("&&"));
}

QString plainTitle(const QString& text)
{
    QString plain = text;
    return plain.replace(QStringLiteral("[*]"), QStringLiteral("[*][*]"));
}

bool PlainLabels::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Polish) {
        auto* label = qobject_cast<QLabel*>(watched);
        if (label != nullptr && label->textFormat() == Qt::AutoText && !isToolTip(*label)) {
            label->setTextFormat(Qt::PlainText);
        }
    }
    return event->type() == QEvent::ToolTip && isInFileDialog(watched);
}

} // namespace fumage::ui
