#include "ui/shell/guarded_application.h"

#include "ui/face/message_box.h"

#include <QScopedValueRollback>

#include <new>

namespace fumage::ui {

bool GuardedApplication::notify(QObject* receiver, QEvent* event)
{
    try {
        return QApplication::notify(receiver, event);
    } catch (const std::bad_alloc&) {
        sayExhausted();
        return false;
    }
}

void GuardedApplication::sayExhausted()
{
    if (m_saying) {
        return;
    }
    const QScopedValueRollback<bool> saying(m_saying, true);
    try {
        MessageBox::warn(activeWindow(), tr("Not enough memory"), tr("There is not enough memory for what you just did. Save your work."));
    } catch (const std::bad_alloc&) {
        qWarning("There is not enough memory.");
    }
}

} // namespace fumage::ui
