#pragma once

#include "ui/preview/picture.h"
#include "ui/preview/preview_renderer.h"
#include "ui/concurrency/latest_only_worker.h"

#include <QObject>

namespace fumage::ui {

/// Makes pictures of an effect on a thread of its own: simulation, light, sprites and paint. The newest request is the
/// one that counts.
class PictureWorker : public QObject {
    Q_OBJECT

public:
    /// @param shelf of baked air, shared with others who look at the same effect
    explicit PictureWorker(std::shared_ptr<AirCache> shelf, QObject* parent = nullptr);

    void request(RenderRequest request) { m_job.post(std::move(request)); }
    /// Gives up what is being made, whatever its quality, and what was asked for.
    void stop() { m_job.stop(); }

signals:
    /// On the thread of this object.
    void pictureReady(fumage::ui::PicturePtr picture);
    /// Memory ran out: the picture that was being made does not come.
    void exhausted();
    /// What it is at. @param share that is done, below 0 where it is not known; Phase::Idle follows when the picture is
    /// done or given up
    void working(fumage::ui::Phase phase, double share);
    /// The picture cannot be made.
    void failed(const fumage::Error& why);

private:
    [[nodiscard]] PreviewRenderer newPreviewRenderer();

    std::shared_ptr<AirCache> m_shelf;
    PreviewRenderer m_previewRenderer; ///< used by the thread of the job alone
    LatestOnlyWorker<RenderRequest> m_job;
};

} // namespace fumage::ui
