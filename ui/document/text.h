#pragma once

#include "core/system/path.h"
#include "core/base/result.h"

#include <filesystem>
#include <string_view>

#include <QString>

namespace fumage::ui {

/// UTF-8 of the core as a QString.
[[nodiscard]] inline QString toQString(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// Names of files as the core takes them, and back: UTF-8 whatever the system, where a path that is made of a
/// std::string would be in the system's own letters.
[[nodiscard]] inline std::filesystem::path toPath(const QString& path)
{
    return pathFrom(path.toStdString());
}
[[nodiscard]] inline QString fromPath(const std::filesystem::path& path)
{
    const std::u8string text = path.u8string();
    return QString::fromUtf8(reinterpret_cast<const char*>(text.data()), static_cast<qsizetype>(text.size()));
}

/// What the core says, in the language of the user. Any thread.
[[nodiscard]] QString translated(const Message& message);
[[nodiscard]] QString translated(const Error& error);

/// A name that steers nothing where it is shown on one line: control characters and what turns the direction of writing
/// are question marks.
[[nodiscard]] QString onOneLine(const QString& text);

/// The beginning of a text that is too long to be shown.
[[nodiscard]] QString shortened(const QString& text, qsizetype longest = 80);

/// The name of a document by its file: without the folder and without the ending of a preset; other dots are part of
/// it.
[[nodiscard]] QString nameOfFile(const QString& path);

/// The name of a document as that of a file: in the folder that is meant, seen, and not too long.
[[nodiscard]] QString fileNameOf(const QString& name);

} // namespace fumage::ui
