#pragma once

#include "ui/help/manual_page.h"

#include <optional>

#include <QRegularExpression>

namespace fumage::ui {

/// What a search has found: a heading that has all words, or under which they stand.
struct ManualHit {
    int page = 0; ///< index
    int heading = -1; ///< index; -1: above the first heading of the page
    QString line; ///< that has most of the words
};

inline constexpr qsizetype kMaxManualHits = 200;

/// Finds words in all pages: whole words or how they begin, in any case; each must stand under the same heading or in
/// it. Headings that have them all come first, then the order of the pages.
/// O(characters * words); some milliseconds for a hundred pages.
[[nodiscard]] QList<ManualHit> searchManual(const QList<ManualPage>& pages, const QString& words);

/// What matches each of the words where they are found; nothing: there are no words.
[[nodiscard]] std::optional<QRegularExpression> wordsPattern(const QString& words);

} // namespace fumage::ui
