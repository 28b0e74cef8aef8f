#include "ui/preview/picture_worker.h"

namespace fumage::ui {

PictureWorker::PictureWorker(std::shared_ptr<AirCache> shelf, QObject* parent)
    : QObject(parent)
    , m_shelf(std::move(shelf))
    , m_previewRenderer(newPreviewRenderer())
    , m_job(
          [this](const RenderRequest& request, const std::stop_token& stop) {
              if (PicturePtr picture = m_previewRenderer.make(request, stop)) {
                  QMetaObject::invokeMethod(
                      this, [this, picture = std::move(picture)] { emit pictureReady(picture); }, Qt::QueuedConnection);
              } else if (m_previewRenderer.trouble()) {
                  QMetaObject::invokeMethod(
                      this, [this, why = *m_previewRenderer.trouble()] { emit failed(why); }, Qt::QueuedConnection);
              }
          },
          [this](const RenderRequest&, const Error& why) {
              m_shelf->clear(); // what it holds may be half done, and takes memory
              m_previewRenderer = newPreviewRenderer();
              QMetaObject::invokeMethod(
                  this, [this, why] { why.code == ErrorCode::OutOfMemory ? emit exhausted() : emit failed(why); },
                  Qt::QueuedConnection);
          },
          // Hasty pictures are never given up: a hand that moves all the time would not see one.
          [](const RenderRequest& request) {
              return request.previewQuality == PreviewQuality::Full
                  || request.previewQuality == PreviewQuality::Intermediate;
          })
{
}

PreviewRenderer PictureWorker::newPreviewRenderer()
{
    return PreviewRenderer(m_shelf, [this](Phase phase, double share) {
        QMetaObject::invokeMethod(
            this, [this, phase, share] { emit working(phase, share); }, Qt::QueuedConnection);
    });
}

} // namespace fumage::ui
