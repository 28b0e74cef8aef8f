#include "ui/document/parameter_text.h"

#include "ui/document/number_text.h"
#include "ui/document/text.h"

#include "core/base/text.h"
#include "core/effect/parameter_table.h"
#include "core/effect/shown_table.h"
#include "core/rendering/view_transform.h"

#include <algorithm>
#include <cmath>

#include <QColor>
#include <QCoreApplication>

namespace fumage::ui {

namespace {

/// The context of all texts of the table in the translation files.
constexpr const char* kContext = "Parameters";

QString translated(std::string_view text)
{
    return QCoreApplication::translate(kContext, std::string(text).c_str());
}

QString rangeOf(const Parameter& parameter)
{
    if (parameter.kind != Kind::Float && parameter.kind != Kind::Int) {
        return {};
    }
    return QStringLiteral("%1 … %2 %3")
        .arg(formatNumber(parameter.hard.low), formatNumber(parameter.hard.high), toQString(unitSymbol(parameter.unit)))
        .trimmed();
}

/// As it is seen on the screen: "#ff8000"; what is brighter than white is as white.
QString hexOf(const glm::vec3& colour)
{
    const auto byte = [](float linear) {
        return static_cast<int>(std::lround(srgbFromLinear(std::clamp(linear, 0.0F, 1.0F)) * 255.0F));
    };
    return QColor(byte(colour.x), byte(colour.y), byte(colour.z)).name();
}

/// The first of a few things; the others are too much for one line.
QString someOf(const QStringList& parts)
{
    constexpr int kMax = 6;
    return parts.mid(0, kMax).join(QLatin1Char(' ')) + (parts.size() > kMax ? QStringLiteral(" …") : QString());
}

QString pointsOf(const Curve& curve)
{
    QStringList points;
    for (const CurvePoint& point : curve.points()) {
        points +=
            QStringLiteral("(%1)").arg(formatNumbers({static_cast<double>(point.x), static_cast<double>(point.y)}));
    }
    return someOf(points);
}

QString stopsOf(const Gradient& gradient)
{
    QStringList stops;
    for (const GradientStop& stop : gradient.stops()) {
        stops += hexOf(stop.colour);
    }
    return someOf(stops);
}

QString sizeOf(const Bitmap& picture)
{
    return picture.empty() ? QCoreApplication::translate("Parameters", "none")
                           : QStringLiteral("%1 × %2").arg(picture.width()).arg(picture.height());
}

} // namespace

QString labelOf(const Parameter& parameter)
{
    return translated(parameter.label);
}

QString groupLabelOf(std::string_view group)
{
    return translated(groupLabel(group));
}

QString choiceLabelOf(std::string_view choice)
{
    QString text = translated(choice);
    text[0] = text[0].toUpper();
    return text;
}

QString fullLabelOf(const Parameter& parameter)
{
    return QStringLiteral("%1: %2").arg(groupLabelOf(parameter.group()), labelOf(parameter));
}

QString valueTextOf(const Parameter& parameter, const Value& value)
{
    switch (parameter.kind) {
    case Kind::Bool:
        return std::get<bool>(value) ? QCoreApplication::translate("Parameters", "on")
                                     : QCoreApplication::translate("Parameters", "off");
    case Kind::Int: return formatNumber(std::get<int>(value), parameter.unit);
    case Kind::Float: return formatNumber(static_cast<double>(std::get<float>(value)), parameter.unit);
    case Kind::Choice: return choiceLabelOf(parameter.choices[static_cast<std::size_t>(std::get<int>(value))]);
    case Kind::Seed: return formatNumber(std::get<std::uint32_t>(value));
    case Kind::Direction:
    case Kind::Vector: {
        const auto& v = std::get<glm::vec3>(value);
        return formatNumbers({static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)});
    }
    case Kind::Colour: return hexOf(std::get<glm::vec3>(value));
    case Kind::Curve: return pointsOf(std::get<Curve>(value));
    case Kind::Gradient: return stopsOf(std::get<Gradient>(value));
    case Kind::Picture: return sizeOf(std::get<Bitmap>(value));
    }
    return {};
}

SearchTexts searchTextsOf(const Parameter& parameter)
{
    const auto both = [](const QString& theirs, std::string_view ours) {
        return theirs + QLatin1Char(' ') + toQString(ours);
    };
    const std::string_view group = parameter.group();
    return {both(labelOf(parameter), parameter.label), both(translated(parameter.synonyms), parameter.synonyms),
        both(groupLabelOf(group), groupLabel(group)),
        both(translated(parameter.tip), parameter.tip) + QLatin1Char(' ') + toQString(parameter.key)};
}

namespace {

/// When a parameter with key frames has its value.
QString readingOf(Animates animates)
{
    switch (animates) {
    case Animates::Never: return {};
    case Animates::Frame: return QCoreApplication::translate("Parameters", "Key frames: as they are at each frame");
    case Animates::Step: return QCoreApplication::translate("Parameters", "Key frames: as they are at each step");
    case Animates::Birth:
        return QCoreApplication::translate("Parameters", "Key frames: as they are at a particle's birth");
    case Animates::Rate: return QCoreApplication::translate("Parameters", "Key frames: summed up over time");
    }
    return {};
}

} // namespace

QString toolTipOf(const Parameter& parameter)
{
    QString text = QStringLiteral("<p><b>%1</b><br>%2</p>")
                       .arg(fullLabelOf(parameter).toHtmlEscaped(), translated(parameter.tip).toHtmlEscaped());
    QStringList facts;
    if (const QString range = rangeOf(parameter); !range.isEmpty()) {
        facts += QCoreApplication::translate("Parameters", "Range: %1").arg(range.toHtmlEscaped());
    }
    if (!parameter.source.empty()) {
        facts +=
            QCoreApplication::translate("Parameters", "Source: %1").arg(translated(parameter.source).toHtmlEscaped());
    }
    if (const QString read = readingOf(parameter.animates); !read.isEmpty()) {
        facts += read;
    }
    facts += QStringLiteral("<code>%1</code>").arg(toQString(parameter.key).toHtmlEscaped());
    return text + QStringLiteral("<p>%1</p>").arg(facts.join(QStringLiteral("<br>")));
}

} // namespace fumage::ui
