#pragma once

#include "ui/export/export_worker.h"
#include "ui/export/queue_file.h"
#include "ui/export/queued_export.h"
#include "ui/export/start_check.h"

#include <QAbstractListModel>

namespace fumage::ui {

/// The exports of the program as a list: done one after the other, from the top, while the artist works. Those that are
/// not done are on the disk too, so that a crash does not lose them.
class ExportQueue : public QAbstractListModel {
    Q_OBJECT

public:
    /// What data() gives beside the name.
    enum Role {
        StateRole = Qt::UserRole, ///< an ExportState as int
        CheckRole, ///< a CheckState as int
        ShareRole, ///< how much is done, 0 to 1; less than 0: not known
        ToldRole, ///< QString: how far it is, or what came of it
        PlaceRole, ///< QString: what is written, its file, its folder
    };

    /// @param folder for the list on the disk
    /// @param shelf  with the air of what is exported, as far as others have baked it
    explicit ExportQueue(
        const QDir& folder, std::shared_ptr<AirCache> shelf = std::make_shared<AirCache>(), QObject* parent = nullptr);
    ~ExportQueue() override;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    /// Renames; an empty name stays what it was.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    bool moveRows(const QModelIndex& source, int row, int count, const QModelIndex& target, int before) override;

    [[nodiscard]] const std::shared_ptr<AirCache>& shelf() const { return m_shelf; }
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
    /// @error TooLarge where there are kMaxJobs already
    [[nodiscard]] Result<quint64> add(ExportJob job);
    /// Lets one that is held, failed or was cancelled wait for its turn; it fails where another that waits writes one
    /// of its files. The disk is asked on another thread.
    void start(int row);
    void startHeld();
    /// Of one that is done: gives up holding its files against its manifest.
    void cancel(int row);
    /// Holds the files of one that is done against its manifest. The mark that comes of it goes where files of that
    /// name are written again.
    void verify(int row);
    /// Takes one from the list that does not run.
    void remove(int row);
    /// Takes those from the list that are done, failed or were cancelled.
    void removeEnded();
    void removeHeld();
    /// Cancels what runs and forgets what waits.
    void stopAll();

    /// Takes what programs that are gone have left into the list, held. Of lists that would make more than kMaxJobs
    /// nothing is taken: their files stay for a program that has room.
    /// @return files that could not be read
    QStringList takeLeftovers();
    /// How many exports had no room then.
    [[nodiscard]] int crowdedOut() const { return m_crowdedOut; }

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
    /// Of one that was to be started: its turn comes, or it fails.
    void takeAnswer(quint64 id, const Status& apart);
    void takeMark(quint64 id, const CheckMark& mark);
    /// Of exports whose files are another's now.
    void dropMarks(const ExportPlan& written);
    void setState(int row, ExportState state, const QString& told = {});
    void follow(int done, int total, const QString& told);
    void end(ExportState state, const QString& told);
    /// Starts the next one where none runs.
    void goOn();
    void keep();

    const QDir m_folder;
    const std::shared_ptr<AirCache> m_shelf;
    std::vector<QueuedExport> m_exports;
    quint64 m_lastId = 0;
    int m_crowdedOut = 0;
    QueueFile m_file;
    ExportWorker m_worker; ///< these last: they end before what hears of them
    ExportCheck m_check;
    StartCheck m_starts;
};

} // namespace fumage::ui
