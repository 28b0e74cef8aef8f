#pragma once

#include "ui/document/document.h"

#include <QDir>
#include <QLockFile>
#include <QTimer>

#include <memory>
#include <vector>

namespace fumage::ui {

/// Keeps a copy of unsaved work on disk, a moment after each change, and takes it away once the work is saved or given up: what is
/// there when a program starts, and belongs to no running one, is what a crash has left.
class Recovery : public QObject {
    Q_OBJECT

public:
    /// @param folder for the copies; made if it is not there
    Recovery(Document& document, const QDir& folder, QObject* parent = nullptr);
    ~Recovery() override;

    /// Writes the copy now, if there is unsaved work.
    void saveNow();
    /// The work is saved or given up.
    void discard();

    /// Work that was left behind.
    struct Found {
        Preset preset;
        QString originalPath; ///< of the document's file; empty where it had none
    };
    /// Takes the work that crashed programs have left in a folder; what is taken is no longer there.
    /// Copies that cannot be read stay.
    [[nodiscard]] static std::vector<Found> take(const QDir& folder);

signals:
    /// The copy cannot be written.
    void failed(const QString& message);

private:
    void follow();

    Document& m_document;
    QDir m_folder;
    QString m_path; ///< of the copy
    std::unique_ptr<QLockFile> m_lock; ///< says that a running program owns the copy
    QTimer m_soon;
    bool m_hasFailed = false;
};

} // namespace fumage::ui
