#include "ui/document/text.h"

#include "core/base/text.h"

#include <QCoreApplication>

namespace fumage::ui {

QString translated(const Message& message)
{
    return toQString(message.text(
        [](const char* sentence) { return QCoreApplication::translate("Messages", sentence).toStdString(); }));
}

QString translated(const Error& error)
{
    return translated(error.whole());
}

QString onOneLine(const QString& text)
{
    return toQString(printable(text.toStdString()));
}

QString shortened(const QString& text, qsizetype longest)
{
    return text.size() <= longest ? text : text.left(longest - 1) + QChar(0x2026);
}

QString nameOfFile(const QString& path)
{
    const QString file = path.mid(path.lastIndexOf(QLatin1Char('/')) + 1);
    const QString ending = QStringLiteral(".json");
    return file.endsWith(ending, Qt::CaseInsensitive) && file.size() > ending.size() ? file.chopped(ending.size())
                                                                                     : file;
}

QString fileNameOf(const QString& name)
{
    constexpr qsizetype kLongest = 60; // at most 240 bytes, which leaves room for an ending
    QString file = name.left(kLongest);
    for (QChar& c : file) {
        if (c == QLatin1Char('/') || c == QLatin1Char('\\') || !(c.isPrint() || c.isSurrogate())) {
            c = QLatin1Char('-');
        }
    }
    // A dot at the beginning would hide the file, or name a folder.
    if (file.startsWith(QLatin1Char('.'))) {
        file[0] = QLatin1Char('-');
    }
    return file;
}

} // namespace fumage::ui
