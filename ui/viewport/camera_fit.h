#pragma once

#include "ui/document/document.h"
#include "ui/concurrency/latest_only_worker.h"

#include "core/base/result.h"
#include "core/export/export_task.h"

namespace fumage::ui {

/// Moves the document's camera so that all smoke of the whole animation, or all but outliers, is in the picture. On a
/// thread of its own; a change of the document meanwhile begins it anew.
class CameraFit : public QObject {
    Q_OBJECT

public:
    /// @param shelf see ExportTask
    explicit CameraFit(Document& document, std::shared_ptr<AirCache> shelf = nullptr);

    [[nodiscard]] bool isRunning() const { return m_running; }
    /// @param outliers percent of the smoke that may be outside; see fitCamera()
    void start(float outliers = 0.0F);

signals:
    /// @param message for the artist
    /// @param forMs how long it is of interest; 0: until the next news
    void news(const QString& message, int forMs);
    /// The camera has been moved, cannot be, or is that of another preset.
    void ended();

private:
    struct Request {
        Scene scene;
        float outliers = 0.0F;
        int number = 0;
    };
    void post();
    /// Has something called on this object's thread, unless something newer has been asked for by then.
    void report(const Request& request, std::function<void()> news);
    void work(const Request& request, const std::stop_token& stop);
    void end(const Result<Camera>& camera);

    Document& m_document;
    const std::shared_ptr<AirCache> m_shelf;
    bool m_running = false;
    float m_outliers = 0.0F; ///< of the newest request
    int m_number = 0; ///< of the newest request: news of others are old
    LatestOnlyWorker<Request> m_job; ///< last: its thread ends first
};

} // namespace fumage::ui
