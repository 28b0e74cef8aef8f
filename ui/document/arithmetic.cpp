#include "ui/document/arithmetic.h"

#include <algorithm>
#include <cmath>

#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

namespace fumage::ui {

namespace {

/// What may part thousands: also the apostrophes of Swiss, and the blanks that French and Swedish use.
constexpr QStringView kGroupSigns = u".,' \u2019\u00a0\u2009\u202f";

bool isDecimalSign(QChar sign)
{
    return sign == u'.' || sign == u',';
}

/// Groups of digits as they are parted in a text: "1", "234" and "5" of "1.234,5", with the signs between.
struct Digits {
    QStringList groups; ///< the first may be empty, as in ".5", and so may the last, as in "5."
    QString signs; ///< one fewer than groups
    qsizetype length = 0; ///< of the text that they take
};

/// Blanks and apostrophes part digits only where three follow: behind them may stand something else.
bool partsThousands(QStringView text, qsizetype at)
{
    qsizetype end = at + 1;
    while (end < text.size() && text[end].isDigit()) {
        ++end;
    }
    constexpr qsizetype kGroup = 3;
    return end - at - 1 == kGroup;
}

Digits digitsOf(QStringView text)
{
    Digits found;
    qsizetype at = 0;
    QString group;
    for (; at < text.size(); ++at) {
        const QChar c = text[at];
        if (c >= u'0' && c <= u'9') {
            group += c;
        } else if (isDecimalSign(c) || (kGroupSigns.contains(c) && partsThousands(text, at))) {
            found.groups += group;
            found.signs += c;
            group.clear();
        } else {
            break;
        }
    }
    found.groups += group;
    found.length = at;
    return found;
}

/// "1", "000", "000": one to three digits, and then always three.
bool areThousands(const QStringList& groups)
{
    constexpr qsizetype kGroup = 3;
    const bool first = !groups.first().isEmpty() && groups.first().size() <= kGroup && !groups.first().startsWith(u'0');
    return first
        && std::all_of(groups.begin() + 1, groups.end(), [](const QString& group) { return group.size() == kGroup; });
}

/// How many of the groups stand before the decimal sign; all where there is none; nothing where they mean no number.
std::optional<qsizetype> wholeGroups(const Digits& digits, const NumberSigns& language)
{
    const qsizetype count = digits.groups.size();
    if (count == 1) {
        return digits.groups.first().isEmpty() ? std::nullopt : std::optional(count);
    }
    const QChar last = digits.signs.back();
    const bool allAlike = digits.signs.count(last) == digits.signs.size();
    if (areThousands(digits.groups) && allAlike) {
        const bool maybeDecimal = digits.signs.size() == 1 && isDecimalSign(last);
        if (!maybeDecimal || language.whole || last == language.group) {
            return count;
        }
    }
    // The last sign is the decimal one: it stands there once, and what is before it are thousands or a single group.
    const QStringList before = digits.groups.mid(0, count - 1);
    const bool once = digits.signs.count(last) == 1 && isDecimalSign(last);
    const bool groupsAlike = digits.signs.count(digits.signs.front()) == digits.signs.size() - (count > 2 ? 1 : 0);
    const bool empty = before.first().isEmpty() && digits.groups.last().isEmpty();
    return once && groupsAlike && !empty && (count == 2 || areThousands(before)) ? std::optional(count - 1)
                                                                                 : std::nullopt;
}

/// sum = product {(+ | -) product}; product = factor {(* | /) factor}; factor = number | ( sum ) | sign factor.
class Reader {
public:
    Reader(QStringView text, const NumberSigns& signs)
        : m_rest(text.trimmed())
        , m_signs(signs)
    {
    }

    [[nodiscard]] QStringView rest() const { return m_rest; }

    std::optional<double> sum()
    {
        std::optional<double> value = product();
        while (value) {
            if (take(u'+')) {
                value = both(value, product(), [](double a, double b) { return a + b; });
            } else if (takeMinus()) {
                value = both(value, product(), [](double a, double b) { return a - b; });
            } else {
                break;
            }
        }
        return value;
    }

private:
    static constexpr int kDeepest = 32;

    template <class Operation>
    static std::optional<double> both(std::optional<double> a, std::optional<double> b, const Operation& operation)
    {
        return a && b ? std::optional(operation(*a, *b)) : std::nullopt;
    }

    std::optional<double> product()
    {
        std::optional<double> value = factor();
        while (value) {
            if (take(u'*') || take(u'\u00d7')) {
                value = both(value, factor(), [](double a, double b) { return a * b; });
            } else if (take(u'/')) {
                value = both(value, factor(), [](double a, double b) { return a / b; });
            } else {
                break;
            }
        }
        return value;
    }

    std::optional<double> factor()
    {
        if (++m_depth > kDeepest) {
            return std::nullopt;
        }
        std::optional<double> value;
        if (take(u'(')) {
            value = sum();
            value = take(u')') ? value : std::nullopt;
        } else if (takeMinus()) {
            value = factor();
            value = value ? std::optional(-*value) : std::nullopt;
        } else {
            value = take(u'+') ? factor() : number();
        }
        --m_depth;
        return value;
    }

    std::optional<double> number()
    {
        const Digits digits = digitsOf(m_rest);
        const std::optional<qsizetype> whole = wholeGroups(digits, m_signs);
        if (!whole) {
            return std::nullopt;
        }
        static const QRegularExpression kExponent(QStringLiteral(R"(^[eE][+\-]?\d+)"));
        const QString exponent = kExponent.match(m_rest.mid(digits.length).toString()).captured();
        const QString plain =
            digits.groups.mid(0, *whole).join(QString()) + QLatin1Char('.') + digits.groups.mid(*whole).join(QString());
        bool ok = false;
        const double value = QLocale::c().toDouble(QLatin1Char('0') + plain + QLatin1Char('0') + exponent, &ok);
        m_rest = m_rest.mid(digits.length + exponent.size()).trimmed();
        return ok ? std::optional(value) : std::nullopt;
    }

    bool take(QChar sign)
    {
        if (!m_rest.startsWith(sign)) {
            return false;
        }
        m_rest = m_rest.mid(1).trimmed();
        return true;
    }

    bool takeMinus() { return take(u'-') || take(u'\u2212'); }

    QStringView m_rest;
    NumberSigns m_signs;
    int m_depth = 0;
};

} // namespace

std::optional<Calculation> calculate(QStringView text, const NumberSigns& signs)
{
    Reader reader(text, signs);
    const std::optional<double> value = reader.sum();
    return value && std::isfinite(*value) ? std::optional(Calculation{*value, reader.rest()}) : std::nullopt;
}

} // namespace fumage::ui
