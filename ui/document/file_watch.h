#pragma once

#include "ui/document/document.h"

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

namespace fumage::ui {

/// Hears of what others do to the file of a document: by the file system where that tells, and whenever look() is
/// called.
class FileWatch : public QObject {
    Q_OBJECT

public:
    explicit FileWatch(Document& document, QObject* parent = nullptr);

    /// As it was seen last.
    [[nodiscard]] DiskState state() const { return m_state; }
    /// Compares with the disk now: some file systems tell nothing.
    DiskState look();

signals:
    void changed(fumage::ui::DiskState state);

private:
    void follow();
    void watch();

    Document& m_document;
    QFileSystemWatcher m_watcher;
    QTimer m_soon; ///< others may take a file away and put another in its place a moment later
    DiskState m_state = DiskState::Same;
};

} // namespace fumage::ui
