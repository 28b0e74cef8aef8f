#include "ui/document/arithmetic.h"

#include <cmath>

#include <QLocale>
#include <QRegularExpression>

namespace fumage::ui {

namespace {

/// sum = product {(+ | -) product}; product = factor {(* | /) factor}; factor = number | ( sum ) | sign factor.
class Reader {
public:
    explicit Reader(QStringView text)
        : m_rest(text.trimmed())
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
        static const QRegularExpression pattern(QStringLiteral(R"(^(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+\-]?\d+)?)"));
        const QRegularExpressionMatch match = pattern.match(m_rest.toString());
        if (!match.hasMatch()) {
            return std::nullopt;
        }
        bool ok = false;
        const double value = QLocale::c().toDouble(match.captured().replace(QLatin1Char(','), QLatin1Char('.')), &ok);
        m_rest = m_rest.mid(match.capturedLength()).trimmed();
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
    int m_depth = 0;
};

} // namespace

std::optional<Calculation> calculate(QStringView text)
{
    Reader reader(text);
    const std::optional<double> value = reader.sum();
    return value && std::isfinite(*value) ? std::optional(Calculation{*value, reader.rest()}) : std::nullopt;
}

} // namespace fumage::ui
