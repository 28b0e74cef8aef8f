#include "ui/help/manual_search.h"

#include <algorithm>
#include <vector>

namespace fumage::ui {

namespace {

constexpr qsizetype kMaxWords = 8;
constexpr qsizetype kMaxText = 200; // characters

QStringList wordsIn(const QString& text)
{
    static const QRegularExpression between(QStringLiteral("[^\\p{L}\\p{N}]+"));
    return text.left(kMaxText).split(between, Qt::SkipEmptyParts).mid(0, kMaxWords);
}

QRegularExpression patternOf(const QStringList& words)
{
    return QRegularExpression(QStringLiteral("(?<![\\p{L}\\p{N}])(?:%1)").arg(words.join(QLatin1Char('|'))),
        QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption);
}

/// Finds words among the lines under one heading.
class SectionSearch {
public:
    explicit SectionSearch(const QList<QRegularExpression>& patterns)
        : m_patterns(patterns)
        , m_found(static_cast<std::size_t>(patterns.size()), false)
    {
    }

    void take(const QString& line)
    {
        qsizetype count = 0;
        for (qsizetype i = 0; i < m_patterns.size(); ++i) {
            if (m_patterns[i].match(line).hasMatch()) {
                m_found[static_cast<std::size_t>(i)] = true;
                ++count;
            }
        }
        if (count > m_most) {
            m_most = count;
            m_line = line;
        }
    }
    [[nodiscard]] bool hasAll() const { return std::ranges::find(m_found, false) == m_found.end(); }
    [[nodiscard]] bool hasAllInOne() const { return m_most == m_patterns.size(); }
    [[nodiscard]] const QString& line() const { return m_line; }

private:
    const QList<QRegularExpression>& m_patterns;
    std::vector<bool> m_found;
    qsizetype m_most = 0;
    QString m_line;
};

} // namespace

QList<ManualHit> searchManual(const QList<ManualPage>& pages, const QString& words)
{
    QList<QRegularExpression> patterns;
    const QStringList all = wordsIn(words);
    for (const QString& word : all) {
        patterns += patternOf({word});
    }
    QList<ManualHit> inHeadings;
    QList<ManualHit> below;
    for (int page = 0; page < pages.size() && !patterns.isEmpty(); ++page) {
        const ManualPage& read = pages[page];
        auto line = read.lines.begin();
        for (int heading = -1; heading < read.headings.size(); ++heading) {
            SectionSearch section(patterns);
            section.take(heading < 0 ? QString() : read.headings[heading].text);
            const bool isHeading = section.hasAllInOne();
            for (; line != read.lines.end() && line->heading == heading; ++line) {
                section.take(line->text);
            }
            if (section.hasAll()) {
                (isHeading ? inHeadings : below) += ManualHit{page, heading, section.line()};
            }
        }
    }
    return (inHeadings + below).mid(0, kMaxManualHits);
}

std::optional<QRegularExpression> wordsPattern(const QString& words)
{
    const QStringList all = wordsIn(words);
    return all.isEmpty() ? std::nullopt : std::optional(patternOf(all));
}

} // namespace fumage::ui
