#include "ui/shell/system_start.h"

#include <csignal>
#include <cstdio>

#include <QByteArray>

namespace fumage::ui {

void prepareSystem()
{
    std::signal(SIGXFSZ, SIG_IGN); // writing says it too, and then the user hears of it
}

bool hasDisplay(const QStringList& words)
{
#ifdef Q_OS_MACOS
    static_cast<void>(words);
    return true;
#else
    for (const char* variable : {"QT_QPA_PLATFORM", "DISPLAY", "WAYLAND_DISPLAY"}) {
        if (!qEnvironmentVariableIsEmpty(variable)) {
            return true;
        }
    }
    return words.contains(QStringLiteral("-platform")) || words.contains(QStringLiteral("--platform"));
#endif
}

void sayAtEnd(const char* line) noexcept
{
    std::fputs(line, stderr);
}

} // namespace fumage::ui
