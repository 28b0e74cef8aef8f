#include "ui/shell/drop_handler.h"

#include "ui/presets/preset_list.h"
#include "ui/shell/document_files.h"

#include <QDragEnterEvent>
#include <QMimeData>
#include <QUrl>
#include <QWidget>

namespace fumage::ui {

namespace {

/// Empty where it is none.
QString fileOf(const QMimeData& data)
{
    const QList<QUrl> urls = data.urls();
    return urls.isEmpty() ? QString() : urls.constFirst().toLocalFile();
}

} // namespace

DropHandler::DropHandler(QWidget& window, DocumentFiles& files, const PresetList& presets)
    : m_files(files)
    , m_presets(presets)
{
    window.setAcceptDrops(true);
    window.installEventFilter(this);
}

bool DropHandler::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::DragEnter) {
        auto& drag = static_cast<QDragEnterEvent&>(*event);
        if (!fileOf(*drag.mimeData()).isEmpty() || drag.mimeData()->hasFormat(PresetList::mimeType())) {
            drag.acceptProposedAction();
            return true;
        }
    }
    if (event->type() == QEvent::Drop) {
        drop(static_cast<QDropEvent&>(*event));
        return true;
    }
    return QObject::eventFilter(watched, event);
}

/// Opens later: the question about unsaved changes must not hold the program that it comes from.
void DropHandler::drop(QDropEvent& event)
{
    event.acceptProposedAction();
    const QString file = fileOf(*event.mimeData());
    // Another program's list may know presets that this one does not.
    if (const Preset* preset =
            m_presets.presetOfId(QString::fromUtf8(event.mimeData()->data(PresetList::mimeType())))) {
        QMetaObject::invokeMethod(
            this, [this, copy = *preset] { m_files.openPreset(copy); }, Qt::QueuedConnection);
    } else if (!file.isEmpty()) {
        QMetaObject::invokeMethod(
            this, [this, file] { m_files.openFile(file); }, Qt::QueuedConnection);
    }
}

} // namespace fumage::ui
