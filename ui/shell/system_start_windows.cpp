#include "ui/shell/system_start.h"

#include "core/base/windows_api.h"

#include <cstdio>

#include <io.h>

#include <QByteArray>

namespace fumage::ui {

namespace {

/// Whether a stream goes anywhere: those of a program with windows only do where somebody redirected them.
bool isOpen(std::FILE* stream)
{
    const int descriptor = _fileno(stream);
    return descriptor >= 0 && _get_osfhandle(descriptor) >= 0;
}

} // namespace

void prepareSystem()
{
    const bool hasOutput = isOpen(stdout);
    const bool hasError = isOpen(stderr);
    if ((!hasOutput || !hasError) && ::AttachConsole(ATTACH_PARENT_PROCESS) != 0) {
        ::SetConsoleOutputCP(CP_UTF8);
        if (!hasOutput) {
            static_cast<void>(std::freopen("CONOUT$", "w", stdout));
        }
        if (!hasError) {
            static_cast<void>(std::freopen("CONOUT$", "w", stderr));
        }
    }
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "windows:darkmode=2"); // its palette is then that of the desktop
    }
}

bool hasDisplay(const QStringList&)
{
    return true;
}

void sayAtEnd(const char* line) noexcept
{
    if (isOpen(stderr)) {
        std::fputs(line, stderr);
    } else {
        ::MessageBoxA(nullptr, line, "Fumage", MB_OK | MB_ICONERROR);
    }
}

} // namespace fumage::ui
