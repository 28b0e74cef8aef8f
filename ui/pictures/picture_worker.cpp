#include "ui/pictures/picture_worker.h"

namespace fumage::ui {

PictureWorker::PictureWorker(std::shared_ptr<AirShelf> shelf, QObject* parent)
    : QObject(parent)
    , m_shelf(std::move(shelf))
    , m_studio(newStudio())
    , m_job(
          [this](const PictureRequest& request, const std::stop_token& stop) {
              if (PicturePtr picture = m_studio.make(request, stop)) {
                  QMetaObject::invokeMethod(
                      this, [this, picture = std::move(picture)] { emit pictureReady(picture); }, Qt::QueuedConnection);
              } else if (m_studio.trouble()) {
                  QMetaObject::invokeMethod(
                      this, [this, why = *m_studio.trouble()] { emit failed(why); }, Qt::QueuedConnection);
              }
          },
          [this](const PictureRequest&, const Error& why) {
              m_shelf->clear(); // what it holds may be half done, and takes memory
              m_studio = newStudio();
              QMetaObject::invokeMethod(
                  this, [this, why] { why.code == ErrorCode::OutOfMemory ? emit exhausted() : emit failed(why); },
                  Qt::QueuedConnection);
          },
          // Hasty pictures are never given up: a hand that moves all the time would not see one.
          [](const PictureRequest& request) {
              return request.haste == Haste::None || request.haste == Haste::Settling;
          })
{
}

Studio PictureWorker::newStudio()
{
    return Studio(m_shelf, [this](Phase phase, double share) {
        QMetaObject::invokeMethod(
            this, [this, phase, share] { emit working(phase, share); }, Qt::QueuedConnection);
    });
}

} // namespace fumage::ui
