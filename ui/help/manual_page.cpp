#include "ui/help/manual_page.h"

#include <utility>

#include <QCoreApplication>
#include <QHash>
#include <QRegularExpression>

namespace fumage::ui {

namespace {

constexpr QChar kMarkBegin(0xE000);
constexpr QChar kMarkEnd(0xE001);
constexpr QChar kSpacedEnd(0xE002); ///< behind a mark: the space after it is of the mark, too

/// What a line says, without the marks of Markdown.
QString plainLine(const QString& markdown)
{
    static const QRegularExpression link(QStringLiteral("!?\\[([^\\]]*)\\]\\([^)]*\\)"));
    static const QRegularExpression begin(QStringLiteral("^\\s*(?:[-+*>]\\s|\\d+[.)]\\s)+"));
    static const QRegularExpression rule(QStringLiteral("^[-:|\\s=*_]+$"));
    static const QRegularExpression marks(QStringLiteral("(?<!\\\\)[*`]|\\\\(?=[\\\\`*_{}\\[\\]()#+.!|-])"));
    QString plain = markdown;
    plain.replace(link, QStringLiteral("\\1")).remove(begin);
    if (rule.match(plain).hasMatch()) {
        return {};
    }
    plain.remove(marks).replace(QLatin1Char('|'), QLatin1Char(' '));
    return plain.simplified();
}

void removeComments(QString& text)
{
    const QString end = QStringLiteral("-->");
    qsizetype begin = text.indexOf(QStringLiteral("<!--"));
    QString without = text.left(begin);
    while (begin >= 0) {
        const qsizetype last = text.indexOf(end, begin);
        const qsizetype next = last < 0 ? -1 : text.indexOf(QStringLiteral("<!--"), last);
        const qsizetype from = last < 0 ? begin : last + end.size(); // one without an end is none
        without += text.mid(from, next < 0 ? -1 : next - from);
        begin = next;
    }
    text = without;
}

QString titleOf(const ManualPage& page)
{
    return page.headings.isEmpty() ? page.file.section(QLatin1Char('/'), -1).section(QLatin1Char('.'), 0, 0)
                                   : page.headings.constFirst().text;
}

/// Reads a page line by line.
class PageParser {
public:
    explicit PageParser(const QString& file) { m_page.file = file; }

    ManualPage parse(const QString& text)
    {
        QString source = text;
        source.remove(kMarkBegin).remove(kMarkEnd).remove(kSpacedEnd).remove(QLatin1Char('\r'));
        removeComments(source);
        const QStringList lines = source.split(QLatin1Char('\n'));
        for (const QString& line : lines) {
            takeLine(line);
            if (m_isTooLong) {
                break;
            }
        }
        if (m_isTooLong) {
            ManualPage refused;
            refused.file = m_page.file;
            refused.title = titleOf(m_page);
            refused.problem =
                QCoreApplication::translate("Manual", "The page %1 has a paragraph that is too long.").arg(m_page.file);
            return refused;
        }
        m_page.markdown = m_out.join(QLatin1Char('\n'));
        m_page.title = titleOf(m_page);
        return std::move(m_page);
    }

private:
    void takeLine(const QString& line)
    {
        m_paragraph = line.trimmed().isEmpty() || !m_fence.isEmpty() ? 0 : m_paragraph + line.size();
        m_isTooLong = m_paragraph > kMaxManualParagraph;
        if (m_isTooLong) {
            return;
        }
        static const QRegularExpression fence(QStringLiteral("^ {0,3}(```+|~~~+)"));
        static const QRegularExpression heading(QStringLiteral("^ {0,3}(#{1,6})\\s+(.*?)(?:\\s+#+)?\\s*$"));
        if (!m_fence.isEmpty()) {
            takeCode(line);
            return;
        }
        if (const QRegularExpressionMatch begin = fence.match(line); begin.hasMatch()) {
            m_fence = begin.captured(1);
            if (!m_waiting.isEmpty()) {
                m_out += addMark(std::exchange(m_waiting, {}));
                m_out += QString();
            }
            m_out += line;
            return;
        }
        if (const QRegularExpressionMatch found = heading.match(line); found.hasMatch()) {
            takeHeading(static_cast<int>(found.capturedLength(1)), found.captured(2));
            return;
        }
        takeText(line);
    }

    void takeCode(const QString& line)
    {
        const QString trimmed = line.trimmed();
        m_out += line;
        if (trimmed.startsWith(m_fence) && QString(trimmed).remove(m_fence.front()).isEmpty()) {
            m_fence.clear();
        } else {
            addLine(trimmed);
        }
    }

    void takeHeading(int level, const QString& written)
    {
        QStringList names = std::exchange(m_waiting, {});
        QString text = written;
        forEachAnchor(text, [&names](const QString& name) {
            names += name;
            return QString();
        });
        text = text.trimmed();
        const QString plain = plainLine(text);
        const QString slug = slugOf(plain);
        const int before = m_slugs[slug]++;
        names += before == 0 ? slug : slug + QLatin1Char('-') + QString::number(before);
        m_page.headings += ManualHeading{level, plain, names.constLast()};
        // With a space behind it: what begins with emphasis or code still does.
        m_out +=
            QString(level, QLatin1Char('#')) + QLatin1Char(' ') + addMark(names) + kSpacedEnd + QLatin1Char(' ') + text;
    }

    void takeText(const QString& written)
    {
        static const QRegularExpression prefix(QStringLiteral("^\\s*(?:[-*+>|]\\s*|\\d+[.)]\\s+)?"));
        static const QRegularExpression letter(QStringLiteral("[\\p{L}\\p{N}]"));
        QString bare = written;
        QStringList names;
        forEachAnchor(bare, [&names](const QString& name) {
            names += name;
            return QString();
        });
        if (bare.trimmed().isEmpty()) { // they are of what comes next
            m_waiting += names;
            m_out += QString();
            return;
        }
        QString text = written;
        forEachAnchor(text, [this](const QString& name) { return addMark({name}); });
        if (!m_waiting.isEmpty() && letter.match(bare).hasMatch()) {
            text.insert(prefix.match(text).capturedLength(), addMark(std::exchange(m_waiting, {})));
        }
        // Qt leaves out pictures that have no words.
        m_out += text.replace(QStringLiteral("![]("), QStringLiteral("![\u00A0]("));
        addLine(plainLine(bare));
    }

    /// Puts something in place of each anchor of HTML.
    template <class Replace>
    static void forEachAnchor(QString& text, const Replace& replace)
    {
        static const QRegularExpression anchor(QStringLiteral("<a\\s+(?:id|name)\\s*=\\s*\"([^\"<>]*)\"\\s*>\\s*</a>"));
        qsizetype from = 0;
        for (QRegularExpressionMatch found = anchor.match(text); found.hasMatch(); found = anchor.match(text, from)) {
            const QString other = replace(found.captured(1));
            text.replace(found.capturedStart(), found.capturedLength(), other);
            from = found.capturedStart() + other.size();
        }
    }

    QString addMark(const QStringList& names)
    {
        m_page.anchors += names;
        return anchorMark(m_page.anchors.size() - 1);
    }

    void addLine(const QString& plain)
    {
        if (!plain.isEmpty()) {
            m_page.lines += ManualLine{static_cast<int>(m_page.headings.size()) - 1, plain};
        }
    }

    ManualPage m_page;
    QStringList m_out;
    QStringList m_waiting; ///< anchors that stood alone, for what comes next
    QHash<QString, int> m_slugs; ///< how often each has been
    qsizetype m_paragraph = 0; ///< characters since the last empty line
    bool m_isTooLong = false;
    QString m_fence; ///< what ends the code that is read; empty: it is none
};

} // namespace

QString anchorMark(qsizetype index)
{
    return kMarkBegin + QString::number(index) + kMarkEnd;
}

QString anchorMarkPattern()
{
    return kMarkBegin + QStringLiteral("(\\d+)") + kMarkEnd + QStringLiteral("(?:%1 ?)?").arg(kSpacedEnd);
}

QString slugOf(const QString& heading)
{
    static const QRegularExpression dropped(QStringLiteral("[^\\p{L}\\p{N} _-]"));
    return heading.toLower().remove(dropped).replace(QLatin1Char(' '), QLatin1Char('-'));
}

ManualPage parsePage(const QString& file, const QString& text)
{
    return PageParser(file).parse(text);
}

} // namespace fumage::ui
