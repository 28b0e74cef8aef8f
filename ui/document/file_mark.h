#pragma once

#include <QByteArray>
#include <QString>

#include <string_view>

namespace fumage::ui {

/// What tells the contents of a file from all others; empty: there is no file.
using FileMark = QByteArray;

/// Of a file as it is now. One that cannot be read has the mark of why. Any thread; reads a file no longer than a
/// preset may be.
[[nodiscard]] FileMark markOfFile(const QString& path);

/// Of a file that would hold a text.
[[nodiscard]] FileMark markOfText(std::string_view text);

} // namespace fumage::ui
