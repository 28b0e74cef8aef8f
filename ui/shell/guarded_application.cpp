#include "ui/shell/guarded_application.h"

#include "ui/document/text.h"
#include "ui/widgets/message_box.h"
#include "ui/concurrency/guarded_thread.h"

#include <QScopedValueRollback>

namespace fumage::ui {

bool GuardedApplication::notify(QObject* receiver, QEvent* event)
{
    bool handled = false;
    runGuarded([&] { handled = QApplication::notify(receiver, event); }, [this](const Error& why) { say(why); });
    return handled;
}

void GuardedApplication::say(const Error& why)
{
    if (m_saying) {
        return;
    }
    const QScopedValueRollback<bool> saying(m_saying, true);
    if (why.code == ErrorCode::OutOfMemory) {
        qWarning("There is not enough memory."); // for when there is none for a box
        MessageBox::warn(activeWindow(), tr("Not enough memory"),
            tr("There is not enough memory for what you just did. Save your work."));
        return;
    }
    const QString text = translated(why);
    if (!m_said.contains(text)) {
        m_said.insert(text);
        MessageBox::warn(activeWindow(), tr("Something failed"),
            tr("What you just did may not have been done. Save your work. %1").arg(text));
    }
}

} // namespace fumage::ui
