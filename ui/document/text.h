#pragma once

#include <string_view>

#include <QString>

namespace fumage::ui {

/// UTF-8 of the core as a QString.
[[nodiscard]] inline QString toQString(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

} // namespace fumage::ui
