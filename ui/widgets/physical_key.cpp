#include "ui/widgets/physical_key.h"

#include <array>

#include <QKeyEvent>
#include <QStringView>

namespace fumage::ui {

namespace {

/// Keys side by side, and the scan code of the first: set 1 of the IBM PC, which Windows tells.
struct KeyRow {
    quint32 first;
    QStringView keys;
};

constexpr std::array kKeyRows{
    KeyRow{2, u"1234567890"},
    KeyRow{16, u"QWERTYUIOP"},
    KeyRow{30, u"ASDFGHJKL"},
    KeyRow{44, u"ZXCVBNM"},
};

#ifdef Q_OS_WIN
constexpr quint32 kOffset = 0;
#else
constexpr quint32 kOffset = 8; // of X11 and Wayland
#endif

QChar keyAt(quint32 scanCode)
{
    for (const KeyRow& row : kKeyRows) {
        const quint32 first = row.first + kOffset;
        if (scanCode >= first && scanCode - first < static_cast<quint32>(row.keys.size())) {
            return row.keys[static_cast<qsizetype>(scanCode - first)];
        }
    }
    return {};
}

bool isLatinOrDigit(int key)
{
    return (key >= Qt::Key_0 && key <= Qt::Key_9) || (key >= Qt::Key_A && key <= Qt::Key_Z);
}

} // namespace

std::optional<int> physicalKey(const QKeyEvent& event)
{
#ifdef Q_OS_MACOS
    return std::nullopt; // tells other codes
#endif
    const QChar key = keyAt(event.nativeScanCode());
    if (key.isNull() || isLatinOrDigit(event.key()) || event.modifiers().testFlag(Qt::KeypadModifier)) {
        return std::nullopt;
    }
    // A sign where a letter lies elsewhere is a key of its own, as the comma of a French keyboard.
    const QString text = event.text();
    const bool isForeignLetter = !text.isEmpty() && text[0].isLetter() && text[0].script() != QChar::Script_Latin;
    return key.isDigit() || isForeignLetter ? std::optional<int>(key.unicode()) : std::nullopt;
}

} // namespace fumage::ui
