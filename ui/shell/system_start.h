#pragma once

#include <QStringList>

namespace fumage::ui {

/// What the system wants before Qt looks at it: on Windows a console that the program was started from has its texts,
/// and a dark desktop a dark program; elsewhere a full disk's limit ends nothing.
void prepareSystem();

/// Whether windows have somewhere to go, as far as that can be known before Qt is asked, which would abort.
/// @param words of the command line
[[nodiscard]] bool hasDisplay(const QStringList& words);

/// Says why the program ends, where it is to be seen: on the standard error; on Windows in a box where there is none.
/// Takes no memory.
/// @param line a whole line
void sayAtEnd(const char* line) noexcept;

} // namespace fumage::ui
