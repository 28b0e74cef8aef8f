#pragma once

#include "ui/concurrency/async_request.h"
#include "ui/presets/thumbnail_store.h"

#include <QTimer>

#include <optional>
#include <vector>

namespace fumage::ui {

/// Plays an effect at the size of a thumbnail, one at a time. Its pictures come from the disk or, rendered behind all
/// else that the program computes, after some seconds; until then nothing is shown. Only those of one effect are kept.
class LoopPlayer : public QObject {
    Q_OBJECT

public:
    static constexpr int kFrames = 24;
    static constexpr int kFrameMs = 100;

    /// @param store where loops are kept from one start to the next; nothing: they are not
    explicit LoopPlayer(std::optional<ThumbnailStore> store = std::nullopt, QObject* parent = nullptr);

    /// Plays an effect in place of the one before; goes on with one that plays already.
    /// @param edge pixels
    void start(const QString& name, const Scene& scene, int edge);
    /// Shows nothing; what is being rendered is given up.
    void stop();

    /// What is played, or will be; empty: nothing.
    [[nodiscard]] const QString& name() const { return m_name; }
    /// The picture of now; null: there is none yet.
    [[nodiscard]] QImage frame() const;
    /// How many loops were rendered here and not found on the disk.
    [[nodiscard]] int rendered() const { return m_rendered; }

signals:
    /// frame() is another one.
    void moved(const QString& name);

private:
    void take(std::vector<QImage> loop, bool isRendered);

    const std::optional<ThumbnailStore> m_store;
    QString m_name;
    std::vector<QImage> m_loop;
    std::size_t m_at = 0;
    int m_rendered = 0;
    QTimer m_tick;
    AsyncRequest m_job; ///< last: its thread ends first
};

} // namespace fumage::ui
