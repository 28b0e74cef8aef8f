#include "ui/face/plain_text.h"

#include <QTextDocument>

namespace fumage::ui {

QString plainToolTip(const QString& text)
{
    return Qt::mightBeRichText(text) ? QStringLiteral("<span style=\"white-space: pre-wrap\">%1</span>").arg(text.toHtmlEscaped()) : text;
}

} // namespace fumage::ui
