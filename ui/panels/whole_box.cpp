#include "ui/panels/whole_box.h"

#include "ui/document/number_text.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fumage::ui {

std::optional<int> WholeBox::read(const QString& text) const
{
    QString number = text.trimmed();
    number = number.startsWith(prefix()) ? number.mid(prefix().size()) : number;
    const QString behind = suffix().trimmed();
    while (!behind.isEmpty() && number.endsWith(behind)) {
        number = number.chopped(behind.size()).trimmed(); // once of the box, and once more where it is typed
    }
    // A box that cannot hold a thousand has none to part: "23.976" is a little less than 24.
    constexpr int kThousand = 1000;
    const std::optional<double> value = parseNumber(number, Unit::None, maximum() >= kThousand);
    if (!value) {
        return std::nullopt;
    }
    return static_cast<int>(
        std::lround(std::clamp(*value, static_cast<double>(minimum()), static_cast<double>(maximum()))));
}

int WholeBox::valueFromText(const QString& text) const
{
    return read(text).value_or(value());
}

QString WholeBox::textFromValue(int value) const
{
    return formatNumber(value);
}

QValidator::State WholeBox::validate(QString& text, int& /*cursor*/) const
{
    return read(text) ? QValidator::Acceptable : QValidator::Intermediate;
}

} // namespace fumage::ui
