#pragma once

#include <QList>
#include <QString>
#include <QStringList>

namespace fumage::ui {

/// A heading of a page.
struct ManualHeading {
    int level = 1; ///< 1 to 6
    QString text; ///< without marks of Markdown
    QString anchor; ///< what leads here
};

/// A line of a page as it is read, for the search.
struct ManualLine {
    int heading = -1; ///< that it stands under, an index; -1: above the first
    QString text; ///< without marks of Markdown
};

/// A page of the manual.
struct ManualPage {
    QString file; ///< from the manual's folder, with '/': "parameters/look.md"
    QString title; ///< its first heading, or the name of its file
    QString problem; ///< why there is nothing to read; empty: there is
    /// What is shown: Markdown without HTML's anchors and comments, with anchorMark() where anchors were.
    QString markdown;
    QList<QStringList> anchors; ///< names of each mark; headings have their words as GitHub makes them, too
    QList<ManualHeading> headings;
    QList<ManualLine> lines;
};

/// What stands for an anchor in the Markdown of a page: characters of private use, which no text has and Markdown
/// leaves alone. Once it is laid out they are taken away again.
[[nodiscard]] QString anchorMark(qsizetype index);

/// What finds such a mark, with a space that belongs to it; its first group is the index.
[[nodiscard]] QString anchorMarkPattern();

/// The anchor of a heading as GitHub makes it: "Size and life" is "size-and-life".
[[nodiscard]] QString slugOf(const QString& heading);

/// What a page may have without an empty line: Qt's time grows with the square of that.
inline constexpr qsizetype kMaxManualParagraph = 8 * 1024; // characters

/// Reads a page; one with a paragraph that is too long has a problem. Its anchors are `<a id="..."></a>` on a line, in
/// it or before it; headings are those that begin with
/// '#'. Nothing else of HTML means anything.
/// O(characters).
[[nodiscard]] ManualPage parsePage(const QString& file, const QString& text);

} // namespace fumage::ui
