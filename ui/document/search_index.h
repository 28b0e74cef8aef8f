#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace fumage::ui {

/// What a thing can be found by, the most telling first.
struct SearchTexts {
    QString name; ///< as it is shown
    QString synonyms; ///< the nearest first
    QString group; ///< where it stands
    QString more; ///< what is said about it
};

/// Finds things by words as people type them: parts of words, comparatives ("thicker"), several at once; the best
/// first.
class SearchIndex {
public:
    void add(const SearchTexts& texts);

    /// How well each thing is found by a text, in the order in which they were added; 0: not at all.
    ///
    /// Each word must be found; where no thing has all of them, those that have one count. Words that begin with what
    /// was typed are found before such that hold it somewhere inside, which are given only where there is nothing else.
    [[nodiscard]] std::vector<double> scores(const QString& text) const;

private:
    struct Entry {
        QStringList name;
        QStringList synonyms;
        QStringList group;
        QStringList more;
    };
    [[nodiscard]] static double scoreOf(const Entry& entry, const QString& word);
    [[nodiscard]] static double scoreOfForms(const Entry& entry, const QStringList& forms);

    std::vector<Entry> m_entries;
};

/// A word, and what it may be a form of: "thinner" of "thin", "wider" of "wide", "clouds" of "cloud".
[[nodiscard]] QStringList wordForms(const QString& word);

} // namespace fumage::ui
