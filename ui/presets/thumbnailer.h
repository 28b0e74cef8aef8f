#pragma once

#include "ui/presets/thumbnail_store.h"
#include "ui/concurrency/guarded_thread.h"

#include <QImage>
#include <QObject>

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <vector>

namespace fumage::ui {

/// Renders small pictures of effects, one after the other, on a thread of its own.
class Thumbnailer : public QObject {
    Q_OBJECT

public:
    /// @param store where pictures are kept from one start to the next; nothing: they are not
    explicit Thumbnailer(std::optional<ThumbnailStore> store = std::nullopt, QObject* parent = nullptr);
    ~Thumbnailer() override;

    /// Asks for a picture; one that was asked for under the same name and has not begun is replaced.
    /// @param edge pixels
    void request(const QString& name, const Scene& scene, int edge);
    /// Forgets what has not begun.
    void clear();

signals:
    void ready(const QString& name, const QImage& image);

private:
    struct Job {
        QString name;
        Scene scene;
        int edge = 0;
        bool isAtHand = false;
    };
    static void complain(const Error& why);
    void run(const std::stop_token& stop);
    [[nodiscard]] QImage pictureOf(const Job& job, const std::stop_token& stop) const;

    const std::optional<ThumbnailStore> m_store;

    std::mutex m_mutex;
    std::condition_variable_any m_wake;
    std::deque<Job> m_jobs;
    GuardedThread m_thread; ///< last: ends before what it uses
};

/// A small picture of an effect at its most telling frame, over the dark of the viewport.
[[nodiscard]] QImage renderThumbnail(const Scene& scene, int edge, const std::stop_token& stop = {});

/// An effect from the beginning of its timeline to its end, in frames at equal distances.
/// @return empty where it was stopped, or cannot be rendered
/// Some seconds.
[[nodiscard]] std::vector<QImage> renderThumbnailLoop(
    const Scene& scene, int edge, int frames, const std::stop_token& stop = {});

/// Whether a picture shows something: it is neither empty nor full of one colour.
[[nodiscard]] bool showsSomething(const QImage& image);

} // namespace fumage::ui
