#include "ui/help/manual_document.h"

#include <algorithm>

#include <QFileInfo>
#include <QFont>
#include <QImage>
#include <QImageReader>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextCursor>
#include <QUrl>

namespace fumage::ui {

namespace {

/// @param left pixels that a picture may have; fewer after it
/// @return null: it is no picture, or too large
QImage readPicture(const QString& path, qint64& left)
{
    if (path.isEmpty() || QFileInfo(path).size() > ManualDocument::kMaxPictureBytes) {
        return {};
    }
    QImageReader reader(path);
    reader.setDecideFormatFromContent(true);
    const QByteArray format = reader.format();
    const QSize size = reader.size();
    const qint64 pixels = static_cast<qint64>(size.width()) * size.height();
    if ((format != "png" && format != "jpeg") || !size.isValid() || pixels > left) {
        return {};
    }
    left -= pixels;
    return reader.read();
}

} // namespace

ManualDocument::ManualDocument(const Manual& manual, int page, const QFont& font)
{
    const ManualPage& read = manual.pages()[page];
    setUndoRedoEnabled(false);
    setDefaultFont(font);
    constexpr qreal kMargin = 14; // pixels
    setDocumentMargin(kMargin);
    if (!read.problem.isEmpty()) {
        setPlainText(read.problem);
        return;
    }
    setMarkdown(read.markdown, MarkdownFeatures(MarkdownDialectGitHub) | MarkdownNoHTML);
    takePictures(manual, page);
    takeMarks(read);
    findPictures();
}

/// Qt reads what it is not given from wherever a name says: it is given something always.
QVariant ManualDocument::loadResource(int /*type*/, const QUrl& /*name*/)
{
    QImage nothing(1, 1, QImage::Format_ARGB32);
    nothing.fill(Qt::transparent);
    return nothing;
}

QList<ManualDocument::Picture> ManualDocument::picturesInText() const
{
    QList<Picture> found;
    for (QTextBlock block = begin(); block.isValid(); block = block.next()) {
        for (QTextBlock::iterator it = block.begin(); !it.atEnd(); ++it) {
            const QTextFragment fragment = it.fragment();
            if (fragment.charFormat().isImageFormat()) {
                found += Picture{
                    fragment.position(), fragment.length(), fragment.charFormat().toImageFormat().name(), QSize()};
            }
        }
    }
    return found;
}

/// Gives each picture a name that leads nowhere but to what was read of it.
void ManualDocument::takePictures(const Manual& manual, int page)
{
    QHash<QString, QString> names;
    qint64 left = kMaxPicturePixels;
    QList<Picture> pictures = picturesInText();
    std::ranges::reverse(pictures); // what comes later may move, what is before does not
    for (const Picture& picture : std::as_const(pictures)) {
        QTextCursor cursor(this);
        cursor.setPosition(picture.position);
        cursor.setPosition(picture.position + picture.length, QTextCursor::KeepAnchor);
        if (!names.contains(picture.file)) {
            const QImage image = readPicture(manual.picture(page, picture.file), left);
            const QString name = image.isNull() ? QString() : QStringLiteral("manual:%1").arg(names.size());
            names.insert(picture.file, name);
            if (!name.isEmpty()) {
                addResource(ImageResource, QUrl(name), image);
                m_sizes.insert(name, image.size());
            }
        }
        const QString name = names.value(picture.file);
        if (name.isEmpty()) {
            cursor.insertText(tr("[This picture cannot be shown: %1]").arg(picture.file), QTextCharFormat());
        } else {
            QTextImageFormat format = cursor.charFormat().toImageFormat();
            format.setName(name);
            cursor.setCharFormat(format);
        }
    }
}

void ManualDocument::takeMarks(const ManualPage& page)
{
    static const QRegularExpression mark(anchorMarkPattern());
    for (QTextBlock block = begin(); block.isValid(); block = block.next()) {
        for (QRegularExpressionMatch found = mark.match(block.text()); found.hasMatch();
             found = mark.match(block.text())) {
            const QStringList names = page.anchors.value(found.captured(1).toInt());
            QTextCursor cursor(block);
            cursor.setPosition(block.position() + static_cast<int>(found.capturedStart()));
            cursor.setPosition(block.position() + static_cast<int>(found.capturedEnd()), QTextCursor::KeepAnchor);
            cursor.removeSelectedText();
            for (const QString& name : names) {
                if (!m_positions.contains(name)) {
                    m_positions.insert(name, block.position());
                }
            }
        }
    }
}

void ManualDocument::findPictures()
{
    m_pictures = picturesInText();
    for (Picture& picture : m_pictures) {
        picture.size = m_sizes.value(picture.file);
    }
}

void ManualDocument::fitPictures(int width)
{
    QTextCursor all(this);
    all.beginEditBlock(); // it is laid out once
    for (const Picture& picture : std::as_const(m_pictures)) {
        const int shown = std::clamp(width, 1, std::max(picture.size.width(), 1));
        QTextCursor cursor(this);
        cursor.setPosition(picture.position);
        cursor.setPosition(picture.position + picture.length, QTextCursor::KeepAnchor);
        QTextImageFormat format = cursor.charFormat().toImageFormat();
        if (static_cast<int>(format.width()) == shown) {
            continue;
        }
        format.setWidth(shown);
        format.setHeight(static_cast<double>(picture.size.height()) * shown / std::max(picture.size.width(), 1));
        cursor.setCharFormat(format);
    }
    all.endEditBlock();
}

} // namespace fumage::ui
