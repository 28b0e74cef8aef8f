#pragma once

#include "core/export/jobs/jobs.h"
#include "ui/concurrency/async_request.h"

#include <QString>

#include <deque>
#include <memory>

namespace fumage::ui {

/// What holding the files of an export against its manifest has come to.
enum class CheckState {
    None,
    Running, ///< or waiting for its turn
    Same, ///< all are as they were written
    Failed, ///< some are not, or the manifest cannot be read
};

struct CheckMark {
    CheckState state = CheckState::None;
    int done = 0; ///< files of `total` that have been looked at while it runs
    int total = 0; ///< 0: not known yet
    QString told{}; ///< how far it is, or what came of it, in words
};

/// Holds the files of exports against their manifests, one export after the other, on a thread of its own and behind
/// all else that the program computes.
class ExportCheck : public QObject {
    Q_OBJECT

public:
    explicit ExportCheck(QObject* parent = nullptr);

    /// Does nothing where this one waits or is looked at already.
    void start(quint64 id, std::shared_ptr<const ExportJob> job);
    /// Takes one away that waits or is looked at; it has no mark then.
    void giveUp(quint64 id);

signals:
    void marked(quint64 id, const fumage::ui::CheckMark& mark);

private:
    struct Wanted {
        quint64 id = 0;
        std::shared_ptr<const ExportJob> job;
    };
    [[nodiscard]] std::deque<Wanted>::iterator find(quint64 id);
    /// Looks at the first of those that wait; none: rests.
    void goOn();
    void end(const CheckMark& mark);

    std::deque<Wanted> m_wanted; ///< the first is being looked at
    AsyncRequest m_job; ///< last: its thread ends first
};

} // namespace fumage::ui
