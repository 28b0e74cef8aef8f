#pragma once

#include "ui/pictures/picture.h"
#include "ui/pictures/studio.h"
#include "ui/work/latest_job.h"

#include <QObject>

namespace fumage::ui {

/// Makes pictures of an effect on a thread of its own: simulation, light, sprites and paint. The newest request is the one that counts.
class PictureWorker : public QObject {
    Q_OBJECT

public:
    /// @param shelf of baked air, shared with others who look at the same effect
    explicit PictureWorker(std::shared_ptr<AirShelf> shelf, QObject* parent = nullptr);

    void request(PictureRequest request) { m_job.post(std::move(request)); }
    /// Gives up what is being made, whatever its haste, and what was asked for.
    void stop() { m_job.stop(); }

signals:
    /// On the thread of this object.
    void pictureReady(fumage::ui::PicturePtr picture);
    /// Memory ran out: the picture that was being made does not come.
    void exhausted();
    /// What it is at. @param share that is done, below 0 where it is not known; Phase::Idle follows when the picture is done or given up
    void working(fumage::ui::Phase phase, double share);
    /// The picture cannot be made.
    void failed(const fumage::Error& why);

private:
    [[nodiscard]] Studio newStudio();

    std::shared_ptr<AirShelf> m_shelf;
    Studio m_studio; ///< used by the thread of the job alone
    LatestJob<PictureRequest> m_job;
};

} // namespace fumage::ui
