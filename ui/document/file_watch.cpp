#include "ui/document/file_watch.h"

#include <utility>

#include <QFileInfo>

namespace fumage::ui {

namespace {

constexpr int kSoonMs = 250;

} // namespace

FileWatch::FileWatch(Document& document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    m_soon.setSingleShot(true);
    m_soon.setInterval(kSoonMs);
    connect(&m_soon, &QTimer::timeout, this, &FileWatch::look);
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, &m_soon, qOverload<>(&QTimer::start));
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, &m_soon, qOverload<>(&QTimer::start));
    connect(&document, &Document::titleChanged, this, &FileWatch::follow);
    connect(&document, &Document::loaded, this, &FileWatch::follow);
    follow();
}

/// What was read or written here may be another file now, or the same as it is.
void FileWatch::follow()
{
    watch();
    if (m_state != DiskState::Same) {
        look();
    }
}

/// The file, and its folder, which tells of a file that is put in its place.
void FileWatch::watch()
{
    const QString path = m_document.filePath();
    QStringList wanted;
    for (const QString& each : {path, path.isEmpty() ? QString() : QFileInfo(path).path()}) {
        if (!each.isEmpty() && QFileInfo::exists(each)) {
            wanted += each;
        }
    }
    for (const QString& old : m_watcher.files() + m_watcher.directories()) {
        if (wanted.removeAll(old) == 0) {
            m_watcher.removePath(old);
        }
    }
    if (!wanted.isEmpty()) {
        m_watcher.addPaths(wanted);
    }
}

DiskState FileWatch::look()
{
    m_soon.stop();
    const DiskState now = m_document.compareWithDisk();
    watch();
    if (std::exchange(m_state, now) != now) {
        emit changed(now);
    }
    return now;
}

} // namespace fumage::ui
