#include "ui/document/search_index.h"

#include <algorithm>

#include <QRegularExpression>

namespace fumage::ui {

namespace {

constexpr double kInside = 3.0; ///< what was typed stands somewhere inside a word
constexpr double kMinGood = 10.0; ///< it is a word, or the beginning of one
constexpr double kShareOfForm = 0.9; ///< another form of the word is found

QStringList wordsOf(const QString& text)
{
    static const QRegularExpression kBetween(
        QStringLiteral(R"([^\p{L}\p{N}]+)"), QRegularExpression::UseUnicodePropertiesOption);
    return text.toLower().split(kBetween, Qt::SkipEmptyParts);
}

struct Weights {
    double whole;
    double beginning;
    double lessPerPlace; ///< words further behind tell less
};
constexpr Weights kName{100.0, 65.0, 6.0};
constexpr Weights kSynonyms{90.0, 45.0, 1.5};
constexpr Weights kGroup{30.0, 20.0, 0.0};
constexpr Weights kMore{16.0, 11.0, 0.0};

double bestOf(const QStringList& words, const QString& word, const Weights& weights)
{
    double best = 0.0;
    for (qsizetype i = 0; i < words.size(); ++i) {
        const double less = weights.lessPerPlace * static_cast<double>(i);
        if (words[i] == word) {
            best = std::max(best, weights.whole - less);
        } else if (words[i].startsWith(word)) {
            best = std::max(best, weights.beginning - less);
        } else if (words[i].contains(word)) {
            best = std::max(best, kInside);
        }
    }
    return best;
}

bool endsDoubled(const QString& word)
{
    return word.size() > 2 && word.back() == word[word.size() - 2];
}

/// What is left of a word without an ending, and what it may have been before the ending came.
void addStems(const QString& word, const QString& ending, QStringList& forms)
{
    constexpr qsizetype kMin = 3;
    if (!word.endsWith(ending) || word.size() - ending.size() < kMin) {
        return;
    }
    const QString stem = word.chopped(ending.size());
    forms += stem;
    forms += stem + QLatin1Char('e');
    if (endsDoubled(stem)) {
        forms += stem.chopped(1);
    }
    if (stem.endsWith(QLatin1Char('i'))) {
        forms += stem.chopped(1) + QLatin1Char('y');
    }
}

} // namespace

QStringList wordForms(const QString& word)
{
    QStringList forms{word};
    for (const char* ending : {"er", "est", "ing", "ness", "ed", "s", "y"}) {
        addStems(word, QLatin1String(ending), forms);
    }
    return forms;
}

void SearchIndex::add(const SearchTexts& texts)
{
    m_entries.push_back({wordsOf(texts.name), wordsOf(texts.synonyms), wordsOf(texts.group), wordsOf(texts.more)});
}

double SearchIndex::scoreOf(const Entry& entry, const QString& word)
{
    return std::max({bestOf(entry.name, word, kName), bestOf(entry.synonyms, word, kSynonyms),
        bestOf(entry.group, word, kGroup), bestOf(entry.more, word, kMore)});
}

double SearchIndex::scoreOfForms(const Entry& entry, const QStringList& forms)
{
    double best = scoreOf(entry, forms.first());
    for (qsizetype i = 1; i < forms.size(); ++i) {
        best = std::max(best, kShareOfForm * scoreOf(entry, forms[i]));
    }
    return best;
}

std::vector<double> SearchIndex::scores(const QString& text) const
{
    std::vector<QStringList> words;
    for (const QString& word : wordsOf(text)) {
        words.push_back(wordForms(word));
    }
    std::vector<double> all(m_entries.size(), 0.0);
    std::vector<double> any(m_entries.size(), 0.0);
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        bool hasAll = !words.empty();
        for (const QStringList& forms : words) {
            const double score = scoreOfForms(m_entries[i], forms);
            any[i] += score >= kMinGood ? score : 0.0;
            all[i] += score;
            hasAll = hasAll && score > 0.0;
        }
        all[i] = hasAll ? all[i] : 0.0;
    }
    const double best = all.empty() ? 0.0 : *std::max_element(all.begin(), all.end());
    if (best <= 0.0) {
        return any;
    }
    const double least = best >= kMinGood * static_cast<double>(words.size()) ? kMinGood : 0.0;
    std::replace_if(
        all.begin(), all.end(), [least](double score) { return score < least; }, 0.0);
    return all;
}

} // namespace fumage::ui
