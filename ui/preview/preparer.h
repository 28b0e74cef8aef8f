#pragma once

#include "ui/preview/picture.h"
#include "ui/concurrency/latest_only_worker.h"

#include "core/scene/scene.h"
#include "core/simulation/scene_simulator.h"

#include <QObject>

#include <atomic>
#include <memory>

namespace fumage::ui {

/// Does what takes long before the frames of a scene come one after the other: bakes the air, and steps all particles
/// to the frame that is played. As important as pictures are, or on a busy machine it would never be done. Meanwhile a
/// PreviewRenderer shows coarser air or fewer particles. Lives on one thread, and works on another.
class Preparer : public QObject {
    Q_OBJECT

public:
    /// @param shelf that the air goes to
    explicit Preparer(std::shared_ptr<AirCache> shelf, QObject* parent = nullptr);

    /// Begins with a scene, unless it is at it already.
    /// @param simulation see RenderRequest::simulation
    void prepare(std::shared_ptr<const Scene> scene, quint64 simulation, int frame);
    /// The frame that is played now: what is prepared follows it.
    void setFrame(int frame) { m_frame.store(frame); }
    /// Gives up; what is baked stays.
    void stop();
    [[nodiscard]] bool isBusy() const { return m_busy; }

signals:
    /// On the thread of this object. @param share that is done
    void working(fumage::ui::Phase phase, double share);
    /// The particles of the frame that was played a moment ago.
    void prepared(std::shared_ptr<fumage::SceneSimulator> simulator, quint64 simulation);
    /// It is done, is not possible, or memory ran out; not where stop() was called. @param succeeded comes after
    /// prepared()
    void ended(bool succeeded);

private:
    struct Request {
        std::shared_ptr<const Scene> scene; ///< null: none
        quint64 simulation = 0;
    };
    void work(const Request& request, const std::stop_token& stop);
    /// @return null: it was stopped, or cannot be done
    [[nodiscard]] std::shared_ptr<SceneSimulator> simulatorAtFrame(const Request& request, const std::stop_token& stop);
    void finish(const Request& request, std::shared_ptr<SceneSimulator> simulator);
    void report(Phase phase, double share);

    std::shared_ptr<AirCache> m_shelf;
    std::atomic<int> m_frame{0};
    bool m_busy = false;
    quint64 m_simulation = 0; ///< that is being prepared
    LatestOnlyWorker<Request> m_job; ///< last: ends before what it uses
};

} // namespace fumage::ui
