#pragma once

#include "ui/concurrency/latest_only_worker.h"

#include <QObject>

namespace fumage::ui {

/// Has one thing at a time done on a thread of its own, and is told of it on the thread that it lives on. What was
/// asked last counts: nothing more comes of what was asked before.
class AsyncRequest : public QObject {
public:
    /// Has something called on the thread that the job lives on, where nothing else has been asked until then.
    using Report = std::function<void(std::function<void()> news)>;
    /// Runs on the thread of its own; should end early when stop is requested.
    using Work = std::function<void(const Report& report, const std::stop_token& stop)>;

    /// Work threw something: no more news come of it. On the thread that the job lives on, where nothing else has been
    /// asked until then.
    using Failed = std::function<void(const Error& why)>;

    explicit AsyncRequest(QObject* parent = nullptr);

    void ask(Work work, Failed failed);
    /// Nothing more comes of what was asked for.
    void forget();

private:
    struct Request {
        quint64 number = 0;
        Work work; ///< none: rest
        Failed failed;
    };
    [[nodiscard]] Report tellerOf(const Request& request);
    void answer(const Request& request, const std::stop_token& stop);

    quint64 m_number = 0; ///< of what was asked last
    LatestOnlyWorker<Request> m_job; ///< last: its thread ends first
};

} // namespace fumage::ui
