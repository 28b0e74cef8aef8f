#pragma once

#include "core/export/plan.h"

#include <QElapsedTimer>
#include <QObject>
#include <QString>

#include <optional>
#include <thread>

namespace fumage::ui {

/// One export at a time, on a thread of its own, while the artist goes on working.
class ExportJob : public QObject {
    Q_OBJECT

public:
    explicit ExportJob(QObject* parent = nullptr);

    [[nodiscard]] bool isRunning() const { return m_running; }
    /// The plan of the last export that was begun.
    [[nodiscard]] const std::optional<ExportPlan>& lastPlan() const { return m_lastPlan; }

    /// @param effect copied: later changes do not touch what is being written
    void start(const Effect& effect, const ExportPlan& plan);
    void cancel();

signals:
    void started();
    /// @param secondsLeft less than 0 while it cannot be told
    void progressed(int done, int total, double secondsLeft);
    /// What leads to the first picture, in words.
    void preparing(const QString& what);
    /// @param remark what the artist should know of the result; empty: nothing
    void finished(const QString& firstFile, const QString& remark);
    void cancelled();
    void failed(const QString& message);

private:
    [[nodiscard]] static QString complaint(const CutOff& cut);
    void tell(Work work, int done, int total);
    void end(const Result<std::optional<Flipbook>>& result);

    std::optional<ExportPlan> m_lastPlan;
    QElapsedTimer m_timer; ///< since the first picture was begun
    bool m_running = false;
    bool m_hasBegun = false; ///< whether a picture is done
    std::jthread m_thread;
};

} // namespace fumage::ui
