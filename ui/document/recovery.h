#pragma once

#include "ui/document/document.h"
#include "ui/document/own_file.h"
#include "ui/concurrency/async_request.h"

#include <QTimer>

#include <functional>
#include <mutex>
#include <optional>
#include <vector>

namespace fumage::ui {

/// Keeps a copy of unsaved work on disk, a moment after each change, also while one comes after another, and takes it
/// away once the work is saved or given up: what is there when a program starts, and belongs to no running one, is what
/// a crash has left. The copies are for the user's eyes alone. They are written on a thread of their own: until a disk
/// has them for certain takes longer than a hand that drags may wait.
class Recovery : public QObject {
    Q_OBJECT

public:
    /// @param folder for the copies; made if it is not there
    Recovery(Document& document, const QDir& folder, QObject* parent = nullptr);
    ~Recovery() override;

    /// Has the copy written now, if there is unsaved work; written() or failed() follows, unless there is newer work by
    /// then.
    void save();
    /// The work is saved or given up.
    void discard();
    /// Has the copy written, if there is unsaved work, and waits for that: the program may be ended by others in a
    /// moment, or go on.
    void keep();
    /// The program is about to be ended by others: the copy is written now, and stays for the next program.
    void leave();

    /// Work that was left behind.
    struct Work {
        Preset preset;
        QString originalPath; ///< of the document's file; empty where it had none
        std::optional<FileMark> originalMark; ///< of that file, when the work began; nothing: not known
        OwnFile copy;
    };
    struct Leftovers {
        std::vector<Work> works; ///< the newest first
        QStringList unreadable; ///< copies that are no presets; they stay
        QStringList
            dangerous; ///< copies that programs ended with before they had shown them, more than once; they stay
    };
    /// Takes possession of what programs that are gone have left in a folder. A copy stays on the disk, and is found
    /// again, until a Recovery that has adopted it discards it.
    [[nodiscard]] static Leftovers find(const QDir& folder);

    /// Shows work in the document, and goes on with its copy.
    void adopt(Work work);
    /// The program has shown the work and lives: its copy may be opened again.
    void markRecovered();

signals:
    /// The disk has the copy.
    void written();
    /// The copy cannot be written; told once until it can be.
    void failed(const QString& message);

private:
    void follow();
    /// What follows a change: the time that is shown may be another, and nothing else.
    void saveUnlessKept();
    [[nodiscard]] std::function<Status()> writer() const;
    void note(const Status& copy);

    Document& m_document;
    OwnFile m_copy; ///< files beside it have its name and more
    QTimer m_soon;
    std::optional<Scene> m_kept; ///< in the copy that was asked for last
    bool m_onTrial = false; ///< adopted work has not been shown yet
    bool m_hasFailed = false;
    bool m_isNothing = true; ///< no copy is there, or asked for
    bool m_isLeft = false;
    std::mutex m_files; ///< held while the copy is written or taken away
    AsyncRequest m_writing; ///< last: its thread ends first
};

} // namespace fumage::ui
