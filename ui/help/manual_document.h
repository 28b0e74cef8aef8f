#pragma once

#include "ui/help/manual.h"

#include <QHash>
#include <QTextDocument>

namespace fumage::ui {

/// A page of the manual as it is laid out. HTML in it stays text; pictures are PNG and JPEG files of the manual's
/// folder, read here and within limits, and what else it names is a text that says so: nothing is loaded later.
class ManualDocument : public QTextDocument {
    Q_OBJECT

public:
    static constexpr qint64 kMaxPictureBytes = 8 * 1024 * 1024;
    static constexpr qint64 kMaxPicturePixels = 4096 * 4096; ///< of all pictures of a page

    /// @param font of its text; headings are larger
    ManualDocument(const Manual& manual, int page, const QFont& font);

    /// Where an anchor is, a position in the text; -1: there is none of this name.
    [[nodiscard]] int positionOf(const QString& anchor) const { return m_positions.value(anchor, -1); }
    /// Makes pictures no wider than a width in pixels.
    void fitPictures(int width);

protected:
    QVariant loadResource(int type, const QUrl& name) override;

private:
    struct Picture {
        int position = 0; ///< in the text
        int length = 1;
        QString file; ///< as the page names it
        QSize size; ///< pixels; empty: it is not shown
    };
    [[nodiscard]] QList<Picture> picturesInText() const;
    void takePictures(const Manual& manual, int page);
    void takeMarks(const ManualPage& page);
    void findPictures();

    QHash<QString, int> m_positions; ///< of anchors
    QHash<QString, QSize> m_sizes; ///< of pictures, by the names that they have in the text, pixels
    QList<Picture> m_pictures; ///< that are shown
};

} // namespace fumage::ui
