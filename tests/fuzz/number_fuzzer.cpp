// What is typed into a number field is either refused or a finite number, and what the field then shows reads back as
// it is shown.

#include "tests/fuzz/expect.h"

#include "ui/document/number_text.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace fumage;
    if (size == 0) {
        return 0;
    }
    const auto unit = static_cast<Unit>(data[0] % (static_cast<unsigned>(Unit::Kelvin) + 1U));
    const QString text = QString::fromUtf8(reinterpret_cast<const char*>(data + 1), static_cast<qsizetype>(size - 1));
    const std::optional<double> number = ui::parseNumber(text, unit);
    if (number) {
        FUMAGE_EXPECT(std::isfinite(*number));
        const QString shown = ui::formatNumber(*number);
        const std::optional<double> again = ui::parseNumber(shown, unit);
        FUMAGE_EXPECT(again && ui::formatNumber(*again) == shown);
    }
    return 0;
}
