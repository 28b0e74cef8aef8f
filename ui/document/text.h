#pragma once

#include "core/base/result.h"

#include <string_view>

#include <QString>

namespace fumage::ui {

/// UTF-8 of the core as a QString.
[[nodiscard]] inline QString toQString(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// What the core says, in the language of the user. Any thread.
[[nodiscard]] QString told(const Message& message);
[[nodiscard]] QString told(const Error& error);

/// The beginning of a text that is too long to be shown.
[[nodiscard]] QString shortened(const QString& text, qsizetype longest = 80);

/// The name of a document as that of a file: in the folder that is meant, seen, and not too long.
[[nodiscard]] QString fileNameOf(const QString& name);

} // namespace fumage::ui
