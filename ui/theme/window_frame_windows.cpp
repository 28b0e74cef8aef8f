#include "ui/theme/window_frame.h"

#include "core/base/windows_api.h"

#include <dwmapi.h>

#include <QApplication>
#include <QEvent>
#include <QWidget>

namespace fumage::ui {

namespace {

/// Source: DWMWINDOWATTRIBUTE of dwmapi.h, Windows 11; Windows 10 before 20H1 has it by another number.
constexpr DWORD kUseDarkMode = 20;
constexpr DWORD kUseDarkModeBefore20h1 = 19;

void setFrame(const QWidget& window, bool dark)
{
    const auto handle = reinterpret_cast<HWND>(window.internalWinId());
    if (handle == nullptr) {
        return; // it comes here again when it has one
    }
    const BOOL wish = dark ? TRUE : FALSE;
    if (FAILED(::DwmSetWindowAttribute(handle, kUseDarkMode, &wish, sizeof wish))) {
        static_cast<void>(::DwmSetWindowAttribute(handle, kUseDarkModeBefore20h1, &wish, sizeof wish));
    }
}

/// Sees windows get their frames.
class FrameKeeper : public QObject {
public:
    using QObject::QObject;

    void follow(bool dark)
    {
        m_isDark = dark;
        for (const QWidget* window : QApplication::topLevelWidgets()) {
            setFrame(*window, dark);
        }
    }

    bool eventFilter(QObject* object, QEvent* event) override
    {
        if (event->type() == QEvent::Show || event->type() == QEvent::WinIdChange) {
            const auto* widget = qobject_cast<QWidget*>(object);
            if (widget != nullptr && widget->isWindow()) {
                setFrame(*widget, m_isDark);
            }
        }
        return QObject::eventFilter(object, event);
    }

private:
    bool m_isDark = false;
};

} // namespace

void setFrames(QApplication& application, bool dark)
{
    const QString name = QStringLiteral("frames");
    auto* keeper = dynamic_cast<FrameKeeper*>(application.findChild<QObject*>(name, Qt::FindDirectChildrenOnly));
    if (keeper == nullptr) {
        keeper = new FrameKeeper(&application);
        keeper->setObjectName(name);
        application.installEventFilter(keeper);
    }
    keeper->follow(dark);
}

} // namespace fumage::ui
