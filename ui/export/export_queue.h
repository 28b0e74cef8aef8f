#pragma once

#include "ui/export/export_worker.h"
#include "ui/export/queue_file.h"

#include <QAbstractListModel>

namespace fumage::ui {

/// What has become of an export of the queue.
enum class ExportState {
    Held, ///< left by a program that is gone; waits for somebody to start it
    Waiting,
    Running,
    Done,
    Failed,
    Cancelled,
};

/// An export of the queue.
struct QueuedExport {
    quint64 id = 0; ///< never 0, and never that of another
    std::shared_ptr<const ExportJob> job;
    ExportState state = ExportState::Waiting;
    int done = 0; ///< files of `total` that are done while it runs
    int total = 0; ///< 0: not known yet
    QString told{}; ///< how far it is, or what came of it, in words
    QString remark{}; ///< of one that is done: what the artist should know of the result

    /// Whether it will be done without anybody doing something for it.
    [[nodiscard]] bool isActive() const { return state == ExportState::Waiting || state == ExportState::Running; }
    /// Whether it is still to be done.
    [[nodiscard]] bool isUnfinished() const { return isActive() || state == ExportState::Held; }
};

/// The exports of the program as a list: done one after the other, from the top, while the artist works. Those that are not done are on the disk too, so
/// that a crash does not lose them.
class ExportQueue : public QAbstractListModel {
    Q_OBJECT

public:
    /// What data() gives beside the name.
    enum Role {
        StateRole = Qt::UserRole, ///< an ExportState as int
        ShareRole, ///< how much is done, 0 to 1; less than 0: not known
        ToldRole, ///< QString: how far it is, or what came of it
        PlaceRole, ///< QString: what is written, its file, its folder
    };

    /// @param folder for the list on the disk
    explicit ExportQueue(const QDir& folder, QObject* parent = nullptr);
    ~ExportQueue() override;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    /// Renames; an empty name stays what it was.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    bool moveRows(const QModelIndex& source, int row, int count, const QModelIndex& target, int before) override;

    [[nodiscard]] const QueuedExport& at(int row) const { return m_exports[static_cast<std::size_t>(row)]; }
    /// @return less than 0 where it is gone
    [[nodiscard]] int rowOf(quint64 id) const;
    /// @return null where it is gone
    [[nodiscard]] const QueuedExport* find(quint64 id) const;
    /// How many are waiting or running.
    [[nodiscard]] int active() const;
    /// How many are left of a program that is gone.
    [[nodiscard]] int held() const;
    /// Those that are waiting, running or held.
    [[nodiscard]] ExportJobs unfinishedJobs() const;
    /// Those that are waiting or running.
    [[nodiscard]] ExportJobs activeJobs() const;

    /// Puts an export at the end, and starts it where none runs.
    /// @return its id
    /// @error TooLarge where there are kMostJobs already
    [[nodiscard]] Result<quint64> add(ExportJob job);
    /// Lets one that is held, failed or was cancelled wait for its turn; it fails where another that waits writes one of its files.
    void start(int row);
    void startHeld();
    void cancel(int row);
    /// Takes one from the list that does not run.
    void remove(int row);
    /// Takes those from the list that are done, failed or were cancelled.
    void removeEnded();
    void removeHeld();
    /// Cancels what runs and forgets what waits.
    void stopAll();

    /// Takes what programs that are gone have left into the list, held.
    /// @return files that could not be read
    QStringList takeLeftovers();

signals:
    /// It was added, or its state or how far it is has changed.
    void changed(quint64 id);
    /// One has been done, has failed or was cancelled while it ran.
    void ended(quint64 id);
    /// None is waiting or running any more.
    void emptied();
    /// The list cannot be kept on the disk.
    void notKept(const QString& message);

private:
    /// That of the one that runs; less than 0: none.
    [[nodiscard]] int running() const;
    template <class IsMeant>
    [[nodiscard]] ExportJobs jobsThat(const IsMeant& areMeant) const;
    template <class IsMeant>
    void removeAll(const IsMeant& isMeant);
    void forgetOldest();
    void append(std::shared_ptr<const ExportJob> job, ExportState state);
    void setState(int row, ExportState state, const QString& told = {});
    void follow(int done, int total, const QString& told);
    void end(ExportState state, const QString& told);
    /// Starts the next one where none runs.
    void goOn();
    void keep();

    const QDir m_folder;
    std::vector<QueuedExport> m_exports;
    quint64 m_lastId = 0;
    QueueFile m_file;
    ExportWorker m_worker; ///< last: it ends before what hears of it
};

} // namespace fumage::ui
