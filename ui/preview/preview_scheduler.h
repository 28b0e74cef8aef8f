#pragma once

#include "ui/preview/picture_cache.h"
#include "ui/preview/picture_worker.h"
#include "ui/preview/preparer.h"

#include "core/effect/parameter.h"

#include <QObject>
#include <QSize>
#include <QTimer>

#include <memory>
#include <optional>

namespace fumage::ui {

/// The pictures of a scene that is being changed, played and looked at: rough ones at once while something moves, the
/// whole one when it rests, and each frame's kept for the next time.
///
/// Takes values and asks by itself for the pictures that they need; for none while nobody sees them. Lives on one
/// thread, and works on others.
class PreviewScheduler : public QObject {
    Q_OBJECT

public:
    static constexpr qint64 kUsualCacheBytes = 256LL * 1024 * 1024;

    /// @param shelf for the air of the effect, of its stand-in, and of the other effect
    explicit PreviewScheduler(std::shared_ptr<AirCache> shelf = std::make_shared<AirCache>(3),
        qint64 cacheBytes = kUsualCacheBytes, QObject* parent = nullptr);

    /// @param stale the first stage of the work that has to be done again
    /// @param layer of it that trails and arrows are about
    /// @param solo  see RenderRequest::solo
    void setScene(const Scene& scene, std::size_t layer, DirtyStage stale, const std::vector<std::size_t>& solo = {});
    /// Other layers are looked at alone.
    void setSolo(const std::vector<std::size_t>& solo);
    /// Trails and arrows are about another layer of the scene.
    void setLayer(std::size_t layer);
    /// Another effect comes next: what is shown and kept of this one is forgotten, and what is on its way is not shown.
    void startAnew();
    void setFrame(int frame);
    void setPlaying(bool playing);
    void setSeen(bool seen);
    /// Pixels of the screen.
    void setSize(const QSize& pixels);
    void setBackdrop(const Backdrop& backdrop);
    /// How much the pictures may take that are kept.
    void setCacheBytes(qint64 bytes);
    /// Whether pictures bring the ways of some particles with them.
    void setTrails(bool wanted);
    /// Whether pictures bring what the air does with them.
    void setAir(bool wanted);
    /// Whether pictures are handed over as sprites instead of painted ones.
    void setSprites(bool wanted);
    /// A scene to compare with, seen by the camera of the first; nothing: none, and no more work for one.
    void setOther(const std::optional<Scene>& other);

    /// Asks which layer is seen at a place of the picture; picked() answers.
    /// @param place from the left and from the top, shares of the picture
    void pick(const glm::vec2& place);

    [[nodiscard]] const Backdrop& backdrop() const { return m_wanted.backdrop; }
    /// The newest picture; null before the first.
    [[nodiscard]] const PicturePtr& picture() const { return m_picture; }
    /// The air of the scenes that are looked at, as far as it is baked.
    [[nodiscard]] const std::shared_ptr<AirCache>& shelf() const { return m_shelf; }
    [[nodiscard]] const PicturePtr& otherPicture() const { return m_otherPicture; }
    /// Whether the picture is all there is to show: of this effect and frame, nothing given up, nothing on its way.
    [[nodiscard]] bool isSettled() const;
    /// Gives up what takes long, until something changes or mayWork() says so: coarser air stands in, and frames that
    /// are not there are not made.
    void stopWork();
    /// Lets it go on.
    void mayWork();
    /// Whether stopWork() has given up something.
    [[nodiscard]] bool isStopped() const { return !m_wanted.mayBake; }
    /// Frames whose pictures are kept, in order.
    [[nodiscard]] QList<int> cachedFrames() const { return m_cache.frames(); }

signals:
    void ready(fumage::ui::PicturePtr picture);
    void otherReady(fumage::ui::PicturePtr picture);
    /// The answer to the newest question. @param layer of the scene; none is seen there
    void picked(std::optional<std::size_t> layer);
    void cacheChanged();
    /// Pictures that were kept are kept no longer.
    void dropped();
    /// What the picture that is wanted waits for, or what is prepared behind those that are played; Phase::Idle:
    /// nothing.
    /// @param share that is done, below 0 where it is not known
    void working(fumage::ui::Phase phase, double share);
    /// The picture of the frame that was asked for last is on its way, or has come.
    void waitingChanged(bool waiting);
    /// There was not enough memory for a picture; it is not tried again until something changes.
    void exhausted();
    /// The picture cannot be made of this effect; as above.
    void failed(const fumage::Error& why);

private:
    void invalidate();
    void beginMoving();
    void rest();
    void refresh(PreviewQuality previewQuality);
    void request(PreviewQuality previewQuality);
    void requestOther(PreviewQuality previewQuality);
    void receive(const PicturePtr& picture);
    void receiveOther(const PicturePtr& picture);
    void giveUp();
    /// Has done behind them what pictures that are played lack.
    void prepareBehind(const Picture& picture);
    void stopPreparing();
    void show(const PicturePtr& picture);
    [[nodiscard]] bool isWanted(const Picture& picture) const;
    [[nodiscard]] PreviewQuality usualQuality() const;

    quint64 m_oldest = 0; ///< the first revision of this effect: pictures of older ones are of others
    RenderRequest m_wanted; ///< as things stand, but for its quality
    quint64 m_picks = 0; ///< that were asked
    bool m_playing = false;
    bool m_seen = false;
    bool m_moving = false; ///< a change came within the last moment
    QTimer m_rest; ///< fires when there has been none for a moment
    std::optional<RenderRequest> m_asked; ///< what the worker is busy with

    PictureCache m_cache; ///< of this revision
    PicturePtr m_picture;
    const std::shared_ptr<AirCache> m_shelf;
    PictureWorker m_worker;
    Preparer m_preparer;

    std::optional<Scene> m_other;
    quint64 m_otherSimulation = 0;
    PicturePtr m_otherPicture;
    std::unique_ptr<PictureWorker> m_otherWorker; ///< only while there is another effect
};

} // namespace fumage::ui
