#include "ui/document/number_text.h"

#include "ui/document/arithmetic.h"
#include "ui/document/text.h"

#include <array>
#include <cmath>

#include <QLocale>

#include <glm/trigonometric.hpp>

namespace fumage::ui {

namespace {

/// Another name for a unit, or another size of it.
struct Alias {
    Unit unit;
    const char16_t* name;
    double factor; ///< of the unit itself
};

constexpr std::array kAliases{
    Alias{Unit::Metres, u"cm", 0.01},
    Alias{Unit::Metres, u"mm", 0.001},
    Alias{Unit::Metres, u"km", 1000.0},
    Alias{Unit::Seconds, u"ms", 0.001},
    Alias{Unit::Seconds, u"min", 60.0},
    Alias{Unit::MetresPerSecond, u"km/h", 1.0 / 3.6},
    Alias{Unit::MetresPerSecond, u"cm/s", 0.01},
    Alias{Unit::MetresPerSecond2, u"m/s2", 1.0},
    Alias{Unit::MetresPerSecond2, u"m/s^2", 1.0},
    Alias{Unit::MetresPerSecond2, u"cm/s\u00b2", 0.01},
    Alias{Unit::MetresPerSecond2, u"cm/s2", 0.01},
    Alias{Unit::MetresPerSecond2, u"cm/s^2", 0.01},
    Alias{Unit::Degrees, u"deg", 1.0},
    Alias{Unit::Degrees, u"rad", glm::degrees(1.0)},
    Alias{Unit::DegreesPerSecond, u"deg/s", 1.0},
    Alias{Unit::DegreesPerSecond, u"rad/s", glm::degrees(1.0)},
    Alias{Unit::Millimetres, u"cm", 10.0},
    Alias{Unit::Kilograms, u"g", 0.001},
    Alias{Unit::None, u"k", 1000.0},
    Alias{Unit::None, u"M", 1000000.0},
    Alias{Unit::None, u"%", 0.01},
};

std::optional<double> factorOf(const QString& name, Unit unit)
{
    if (name.isEmpty() || name == toQString(unitSymbol(unit))) {
        return 1.0;
    }
    for (const Alias& alias : kAliases) {
        if (alias.unit == unit && name == QStringView(alias.name)) {
            return alias.factor;
        }
    }
    return std::nullopt;
}

/// Of a language only its decimal sign is used: grouped or other digits could not be typed in again everywhere.
bool hasDecimalComma()
{
    return QLocale().decimalPoint() == QStringLiteral(",");
}

} // namespace

QString formatNumber(double value, int digits)
{
    constexpr double kLargestWhole = 4294967295.0;
    constexpr double kNoFraction = 99999.5; // from here on five digits are not even enough for the whole number
    const bool isWhole = value == std::round(value) || std::abs(value) >= kNoFraction;
    if (isWhole && std::abs(value) <= kLargestWhole) {
        return QString::number(std::llround(value));
    }
    QString text = QLocale::c().toString(value, 'g', digits);
    return hasDecimalComma() ? text.replace(QLatin1Char('.'), QLatin1Char(',')) : text;
}

QString formatNumbers(std::initializer_list<double> values)
{
    QStringList texts;
    for (const double value : values) {
        texts << formatNumber(value);
    }
    return texts.join(hasDecimalComma() ? QStringLiteral("; ") : QStringLiteral(", "));
}

QString formatNumber(double value, Unit unit, int digits)
{
    const QString number = formatNumber(value, digits);
    const QString symbol = toQString(unitSymbol(unit));
    const bool attached = unit == Unit::Degrees;
    return symbol.isEmpty() ? number : number + (attached ? QString() : QStringLiteral(" ")) + symbol;
}

QString formatFixed(double value, int decimals)
{
    QString text = QLocale::c().toString(value, 'f', decimals);
    return hasDecimalComma() ? text.replace(QLatin1Char('.'), QLatin1Char(',')) : text;
}

std::optional<double> parseNumber(const QString& text, Unit unit, bool whole)
{
    const QLocale language;
    const auto sign = [](const QString& of) { return of.isEmpty() ? QChar() : of[0]; };
    const NumberSigns signs{sign(language.decimalPoint()), sign(language.groupSeparator()), whole};
    const std::optional<Calculation> calculation = calculate(text, signs);
    const std::optional<double> factor = calculation ? factorOf(calculation->rest.toString(), unit) : std::nullopt;
    if (!factor || !std::isfinite(calculation->value * *factor)) {
        return std::nullopt;
    }
    return calculation->value * *factor;
}

} // namespace fumage::ui
