#pragma once

#include "ui/concurrency/guarded_thread.h"

#include "core/export/jobs/jobs.h"

#include <QElapsedTimer>
#include <QObject>
#include <QString>

#include <memory>

namespace fumage::ui {

/// Does one export at a time, on a thread of its own and behind all else that the program computes.
class ExportWorker : public QObject {
    Q_OBJECT

public:
    explicit ExportWorker(QObject* parent = nullptr);

    [[nodiscard]] bool isRunning() const { return m_job != nullptr; }

    /// Does nothing while one runs.
    /// @param shelf see ExportTask
    void start(std::shared_ptr<const ExportJob> job, std::shared_ptr<AirCache> shelf);
    void cancel();

signals:
    /// @param secondsLeft less than 0 while it cannot be told
    void progressed(int done, int total, double secondsLeft);
    /// What leads to the first picture, in words.
    void preparing(const QString& what);
    /// @param remark what the artist should know of the result; empty: nothing
    void finished(const QString& remark);
    void cancelled();
    void failed(const QString& message);

private:
    [[nodiscard]] static QString complaint(const CutOff& cut, const ExportPlan& plan);
    void report(ProgressPhase work, int done, int total);
    /// On the thread of the work.
    void endSoon(const Result<std::optional<Flipbook>>& result);
    void end(const Result<std::optional<Flipbook>>& result);

    std::shared_ptr<const ExportJob> m_job; ///< null: none runs
    QElapsedTimer m_timer; ///< since the first picture was begun
    bool m_hasBegun = false; ///< whether a picture is done
    GuardedThread m_thread;
};

} // namespace fumage::ui
